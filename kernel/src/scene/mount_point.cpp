#include <Eigen/Geometry>
#include <limits>

#include "delos/geometry/surface.h"
#include "delos/scene/scene.h"

namespace delos {
namespace {

/// Where a ray is hit first, and the triangle's normal, of any length and either side.
struct Hit {
  double t = std::numeric_limits<double>::infinity();
  Eigen::Vector3d normal;
};

/// The first t ≥ 0 at which p + t·d is on the mesh.
///
/// Source: Möller, Trumbore (1997), Fast, minimum storage ray-triangle intersection,
///         J. Graphics Tools 2(1), 21-28. A ray through an edge may be rounded past
///         both of its triangles: the edges are taken to be a little wider.
std::optional<Hit> first_hit(const MeshShape& shape, const Eigen::Vector3d& p,
                             const Eigen::Vector3d& d) {
  constexpr double kWider = 1e-12;
  Hit first;
  const auto corner = [&](std::uint32_t i) -> Eigen::Vector3d {
    return shape.scale * shape.mesh->vertices[i];
  };
  for (const auto& [i, j, k] : shape.mesh->triangles) {
    const Eigen::Vector3d a = corner(i), ab = corner(j) - a, ac = corner(k) - a;
    const Eigen::Vector3d normal = ab.cross(ac);
    const double slope = -d.dot(normal);
    if (slope == 0) continue;
    const Eigen::Vector3d ap = p - a, m = ap.cross(d);
    const double t = ap.dot(normal) / slope;
    const double v = ac.dot(m) / slope, w = -ab.dot(m) / slope;
    if (t < 0 || !(t < first.t) || v < -kWider || w < -kWider || v + w > 1 + kWider)
      continue;
    first = {t, normal};
  }
  if (first.t == std::numeric_limits<double>::infinity()) return std::nullopt;
  return first;
}

MountPoint point_of(const PatchSurface& s, const std::vector<double>& c) {
  const SurfacePoint at = patch_point({s.origin, s.u, s.v}, c[0], c[1]);
  return {at.p, at.normal};
}

struct At {
  const std::vector<double>& coordinates;

  std::optional<MountPoint> operator()(const PatchSurface& s) const {
    return point_of(s, coordinates);
  }

  std::optional<MountPoint> operator()(const RailSurface& s) const {
    return MountPoint{rail_point(s.points, coordinates[0]).p, {}};
  }

  std::optional<MountPoint> operator()(const MeshSurface& s) const {
    const MountPoint from = point_of(s.from, coordinates);
    const Eigen::Vector3d& d = *from.normal;
    const auto hit = first_hit(s.mesh, from.p, d);
    if (!hit) return std::nullopt;
    const Eigen::Vector3d normal = hit->normal.stableNormalized();
    return MountPoint{from.p + hit->t * d,
                      normal.dot(d) < 0 ? normal : Eigen::Vector3d(-normal)};
  }
};

}  // namespace

std::optional<MountPoint> mount_point(const SurfaceEntry& surface,
                                      const std::vector<double>& coordinates) {
  return std::visit(At{coordinates}, surface.shape);
}

}  // namespace delos
