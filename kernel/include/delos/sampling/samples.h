// The points and orientations at which a system is evaluated.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "delos/api.h"
#include "delos/sampling/sets.h"

namespace delos {

/// A regular grid behind a range of samples: x varies fastest, then y, then z.
struct GridShape {
  Eigen::Vector3d origin;                    ///< the first sample, metres
  Eigen::Vector3d step;                      ///< metres along x, y, z
  Eigen::Matrix<std::int64_t, 3, 1> counts;  ///< samples along x, y, z, ≥ 1
};

/// A parallelogram of samples: u varies fastest.
struct PlaneShape {
  Eigen::Vector3d origin, u,
      v;                   ///< metres; the far edges are origin + u and origin + v
  Eigen::Vector2i counts;  ///< samples along u and v, ≥ 1
};

/// The vertices of a mesh.
struct SurfaceShape {
  /// Corners as indices of the part's samples, from 0.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Samples with no neighbours.
struct ScatteredShape {};

/// The nodes of an octree and its leaves.
struct OctreeShape {
  /// Corners of each leaf as indices of samples, x fastest, then y, then z.
  std::vector<std::array<std::uint32_t, 8>> cells;
  std::vector<int> levels;  ///< of each leaf: halvings of a root
};

/// One sample set of the scene: a range of the points and how they hang together.
struct SamplePart {
  std::string name;       ///< may be empty
  std::size_t first = 0;  ///< index of its first point
  std::size_t count = 0;  ///< number of points, ≥ 1
  std::variant<GridShape, PlaneShape, ScatteredShape, SurfaceShape, OctreeShape> shape;
};

/// All sample points of a scene, part after part.
struct Samples {
  std::vector<Eigen::Vector3d> points;  ///< world, metres
  std::vector<SamplePart> parts;        ///< cover the points in order
};

/// Number of samples of a set, without making them. Saturates at the largest int64.
/// 0 of an adaptive one, whose samples aren't known before the field.
[[nodiscard]] DELOS_API std::int64_t sample_count(const SampleSet& set);

/// Make the points. Grids include both ends where the step divides the box.
/// @pre every set has at least one sample and they fit in memory
/// @throws std::invalid_argument one sentence: a set is adaptive, so that its samples
///         are chosen while a field is evaluated
[[nodiscard]] DELOS_API Samples make_samples(const std::vector<SampleSet>& sets);

}  // namespace delos
