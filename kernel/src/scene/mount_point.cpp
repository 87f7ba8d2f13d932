#include <Eigen/Geometry>
#include <limits>

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

struct At {
  const std::vector<double>& coordinates;

  std::optional<SurfacePoint> operator()(const PatchSurface& s) const {
    return SurfacePoint{
        s.origin + coordinates[0] * s.u + coordinates[1] * s.v,
        s.u.stableNormalized().cross(s.v.stableNormalized()).stableNormalized()};
  }

  std::optional<SurfacePoint> operator()(const RailSurface& s) const {
    double length = 0;
    for (std::size_t i = 1; i < s.points.size(); ++i)
      length += (s.points[i] - s.points[i - 1]).norm();
    double left = coordinates[0] * length;
    for (std::size_t i = 1; i < s.points.size(); ++i) {
      const Eigen::Vector3d piece = s.points[i] - s.points[i - 1];
      if (left < piece.norm())
        return SurfacePoint{s.points[i - 1] + left / piece.norm() * piece, {}};
      left -= piece.norm();
    }
    return SurfacePoint{s.points.back(), {}};
  }

  std::optional<SurfacePoint> operator()(const MeshSurface& s) const {
    const SurfacePoint from = *(*this)(s.from);
    const Eigen::Vector3d& d = *from.normal;
    const auto hit = first_hit(s.mesh, from.p, d);
    if (!hit) return std::nullopt;
    const Eigen::Vector3d normal = hit->normal.stableNormalized();
    return SurfacePoint{from.p + hit->t * d,
                        normal.dot(d) < 0 ? normal : Eigen::Vector3d(-normal)};
  }
};

}  // namespace

std::optional<SurfacePoint> surface_point(const Surface& surface,
                                          const std::vector<double>& coordinates) {
  return std::visit(At{coordinates}, surface.shape);
}

}  // namespace delos
