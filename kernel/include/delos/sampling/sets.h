// Sets of sample points and target orientations, as scenes write them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "delos/api.h"
#include "delos/geometry/body.h"
#include "delos/sampling/grid.h"

namespace delos {

/// How several target orientations at one point become one value.
enum class OrientationRule {
  worst,        ///< the worst value
  mean,         ///< the mean of the values
  information,  ///< the value of the mean information: visibility as a probability
};

/// counts[0]×counts[1] samples on the parallelogram origin + a·u + b·v, a and b in [0,
/// 1].
struct PlaneSampling {
  Eigen::Vector3d origin, u, v;  ///< metres
  Eigen::Vector2i counts;        ///< ≥ 1 each
  friend bool operator==(const PlaneSampling&, const PlaneSampling&) = default;
};

/// Given points; `file` is the .ptl or .csv they were read from, empty when inline.
struct PointSampling {
  std::string file;                     ///< as written, relative to the scene's folder
  std::vector<Eigen::Vector3d> points;  ///< metres
  friend bool operator==(const PointSampling&, const PointSampling&) = default;
};

/// Along the line through waypoints: themselves, or places at equal distances.
struct PathSampling {
  std::string file;  ///< what they were read from, as written; empty when inline
  std::vector<Eigen::Vector3d> waypoints;  ///< metres, two or more
  std::optional<double> step;  ///< distance along the path, metres, > 0; or …
  std::optional<int> count;    ///< samples from end to end, ≥ 2
  friend bool operator==(const PathSampling&, const PathSampling&) = default;
};

/// The vertices of a mesh that is placed in the world.
struct MeshSampling {
  MeshShape surface;
  friend bool operator==(const MeshSampling&, const MeshSampling&) = default;
};

/// A box sampled by an octree, only as finely as the field needs.
struct AdaptiveSampling {
  Eigen::Vector3d min;      ///< metres
  Eigen::Vector3d max;      ///< metres, > min
  double tolerance = 0.02;  ///< relative error of the metric where it is smooth, > 0
  int depth = 6;            ///< most halvings of the box, 1 to 12
  std::optional<std::int64_t> evaluations;  ///< stop at about so many, > 0
  std::optional<double> seconds;            ///< stop after about so long, > 0
  std::optional<double> near_value;  ///< refine only around this metric's value, SI
  std::optional<Eigen::AlignedBox3d> within;  ///< refine only inside, metres
  friend DELOS_API bool operator==(const AdaptiveSampling& a,
                                   const AdaptiveSampling& b);
};

/// One named set of sample points.
struct SampleSet {
  std::string name;  ///< may be empty
  std::variant<VolumeSampling, PlaneSampling, PointSampling, PathSampling, MeshSampling,
               AdaptiveSampling>
      shape;
  friend bool operator==(const SampleSet&, const SampleSet&) = default;
};

/// Target orientations tried at every sample point.
struct Orientations {
  std::vector<Eigen::Vector3d> rpy = {Eigen::Vector3d::Zero()};  ///< radians
  OrientationRule combine = OrientationRule::worst;
  friend bool operator==(const Orientations&, const Orientations&) = default;
};

}  // namespace delos
