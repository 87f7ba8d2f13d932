// Where things are mounted: points and directions on rails, patches and meshes.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "delos/api.h"
#include "delos/geometry/mesh.h"

namespace delos {

/// A point on a surface.
struct SurfacePoint {
  Eigen::Vector3d p;       ///< metres
  Eigen::Vector3d normal;  ///< unit, outward
};

/// A point on a rail.
struct RailPoint {
  Eigen::Vector3d p;        ///< metres
  Eigen::Vector3d tangent;  ///< unit, towards the rail's end
};

/// The point at part s of a polyline's length; at a corner, with the tangent of what
/// follows. s outside [0, 1] gives the ends.
/// @param polyline at least two points, metres; equal neighbours are allowed, but not
/// all
/// @throws std::invalid_argument the polyline has no length
[[nodiscard]] DELOS_API RailPoint
rail_point(const std::vector<Eigen::Vector3d>& polyline, double s);

/// A parallelogram from origin to origin + u + v, facing along u × v.
/// @pre u and v span a plane
struct Patch {
  Eigen::Vector3d origin, u, v;  ///< metres
};

/// origin + a·u + b·v, with a and b limited to [0, 1].
[[nodiscard]] DELOS_API SurfacePoint patch_point(const Patch& patch, double a,
                                                 double b);

/// A mesh that things are mounted on. Immutable, cheap to copy, and safe to ask from
/// many threads at once.
class DELOS_API MountingSurface {
 public:
  /// @pre vertices finite, indices in range
  /// @throws std::invalid_argument no triangle has area
  /// @cost n log n
  explicit MountingSurface(const TriangleMesh& mesh);

  /// The point of the mesh that is closest to p, and the normal of a triangle there;
  /// where several are closest, an arbitrary one, but always the same.
  /// @pre p finite
  [[nodiscard]] SurfacePoint closest(const Eigen::Vector3d& p) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace delos
