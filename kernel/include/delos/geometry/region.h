// Bodies that samples, devices or targets must be in or keep away from.
#pragma once

#include <Eigen/Core>

#include "delos/api.h"
#include "delos/geometry/mesh.h"
#include "delos/geometry/occluders.h"
#include "delos/geometry/surface.h"

namespace delos {

/// What a closed mesh encloses: a box by make_box(), a prism by extrude(), or a file's.
/// Immutable, cheap to copy, and safe to ask from many threads at once.
class DELOS_API Region {
 public:
  /// @pre vertices finite, indices in range
  /// @throws std::invalid_argument the mesh isn't closed (see MeshDefects) or has no
  /// area
  explicit Region(const TriangleMesh& mesh);

  /// Whether p is inside or on the surface; exact, as Occluders::contains().
  [[nodiscard]] bool contains(const Eigen::Vector3d& p) const;

  /// Distance from p to the surface, metres: negative inside, positive outside.
  /// @pre p finite
  [[nodiscard]] double signed_distance(const Eigen::Vector3d& p) const;

 private:
  Occluders body_;
  MountingSurface surface_;
};

}  // namespace delos
