#include "geometry/occlusion/segment_triangle.h"

#include <Eigen/Geometry>
#include <optional>

#include "geometry/mesh/kernel.h"

namespace delos {
namespace {

/// The sign of x where it is farther from 0 than `slack`, else 0.
int sign(double x, double slack) { return (x > slack) - (x < -slack); }

/// What meets() says, by rounded numbers; nullopt where they aren't certain.
///
/// The segment a + t d meets the plane of p + u e + v g where, with f = a − p and
/// D = e·(d × g),
///     D u = f·(d × g),  D v = d·(f × e),  D t = g·(f × e),
/// and the triangle where D u, D v and D (1 − u − v), and if so D t and D (1 − t), have
/// the sign of D (Möller & Trumbore 1997, Journal of Graphics Tools 2(1), 21–28). Each
/// determinant is a sum of six products of three differences: eight roundings, that is
/// 6 · 8 · 1.1e-16 = 5.3e-15 of the product of the largest factors.
std::optional<bool> surely_meets(const Corners& triangle, const Segment& s) {
  const Eigen::Vector3d d = s.b - s.a, f = s.a - triangle[0];
  const Eigen::Vector3d e = triangle[1] - triangle[0], g = triangle[2] - triangle[0];
  const Eigen::Vector3d d_g = d.cross(g), f_e = f.cross(e);
  const double whole = e.dot(d_g), u = f.dot(d_g), v = d.dot(f_e), w = whole - u - v;
  const double size_d = d.cwiseAbs().maxCoeff(), size_f = f.cwiseAbs().maxCoeff();
  const double size_e = std::max(e.cwiseAbs().maxCoeff(), g.cwiseAbs().maxCoeff());
  const double least = std::min({size_d, size_f, size_e});
  const double most = std::max({size_d, size_f, size_e});
  if (!(least > 1e-90 && most < 1e90)) return std::nullopt;

  const double slack = 2e-14 * size_d * size_e * (size_f + size_e);
  const int side_u = sign(u, slack), side_v = sign(v, slack), side_w = sign(w, slack);
  if (side_u * side_v < 0 || side_v * side_w < 0 || side_w * side_u < 0) return false;
  if (side_u == 0 || side_v == 0 || side_w == 0) return std::nullopt;

  const double start = side_u * g.dot(f_e), end = side_u * whole - start;
  const double height_slack = 2e-14 * size_e * size_e * (size_f + size_d);
  const int after_start = sign(start, height_slack),
            before_end = sign(end, height_slack);
  if (after_start < 0 || before_end < 0) return false;
  if (after_start == 0 || before_end == 0) return std::nullopt;
  return true;
}

}  // namespace

bool meets(const Corners& triangle, const Segment& s) {
  if (const auto sure = surely_meets(triangle, s)) return *sure;
  const Kernel::Triangle_3 exact(cgal_point(triangle[0]), cgal_point(triangle[1]),
                                 cgal_point(triangle[2]));
  return CGAL::do_intersect(exact, Kernel::Segment_3(cgal_point(s.a), cgal_point(s.b)));
}

}  // namespace delos
