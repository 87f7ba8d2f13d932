// Meshes and points with integer coordinates, for which 128-bit integers tell without
// rounding what meets what.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "delos/geometry/mesh.h"

namespace delos::test {

__extension__ using Integer = __int128;

/// Coordinates up to 2²⁰ in size: determinants of three differences stay below 2⁶⁷.
struct IntPoint {
  std::int64_t x = 0, y = 0, z = 0;
};

inline IntPoint operator-(const IntPoint& a, const IntPoint& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline int sign(Integer v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

/// Sign of (b − a) × (c − a) · (d − a).
inline int side(const IntPoint& a, const IntPoint& b, const IntPoint& c,
                const IntPoint& d) {
  const IntPoint u = b - a, v = c - a, w = d - a;
  return sign(Integer(w.x) * (u.y * v.z - u.z * v.y) +
              Integer(w.y) * (u.z * v.x - u.x * v.z) +
              Integer(w.z) * (u.x * v.y - u.y * v.x));
}

using IntTriangle = std::array<IntPoint, 3>;

/// (b − a) × (c − a).
inline IntPoint normal(const IntTriangle& t) {
  const IntPoint u = t[1] - t[0], v = t[2] - t[0];
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// In the triangle's plane, seen along the axis that its normal is longest in.
struct Plane2 {
  int drop;
  std::array<std::int64_t, 2> operator()(const IntPoint& p) const {
    if (drop == 0) return {p.y, p.z};
    if (drop == 1) return {p.z, p.x};
    return {p.x, p.y};
  }
  int turn(const IntPoint& a, const IntPoint& b, const IntPoint& c) const {
    const auto p = (*this)(a), q = (*this)(b), r = (*this)(c);
    return sign(Integer(q[0] - p[0]) * (r[1] - p[1]) -
                Integer(q[1] - p[1]) * (r[0] - p[0]));
  }
  /// Whether c, on the line through a and b, is between them.
  bool between(const IntPoint& a, const IntPoint& b, const IntPoint& c) const {
    const auto p = (*this)(a), q = (*this)(b), r = (*this)(c);
    for (int i = 0; i < 2; ++i) {
      if (r[i] < std::min(p[i], q[i]) || r[i] > std::max(p[i], q[i])) return false;
    }
    return true;
  }
  bool cross(const IntPoint& a, const IntPoint& b, const IntPoint& c,
             const IntPoint& d) const {
    const int abc = turn(a, b, c), abd = turn(a, b, d);
    const int cda = turn(c, d, a), cdb = turn(c, d, b);
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) ||
           (cda == 0 && between(c, d, a)) || (cdb == 0 && between(c, d, b));
  }
};

/// Whether the closed segment pq and the closed triangle have a point in common.
/// @pre the triangle has area
inline bool segment_meets(const IntTriangle& t, const IntPoint& p, const IntPoint& q) {
  const int at_p = side(t[0], t[1], t[2], p), at_q = side(t[0], t[1], t[2], q);
  if (at_p * at_q > 0) return false;
  if (at_p != 0 || at_q != 0) {
    // The line pq pierces the plane between p and q: within the triangle if it passes
    // all edges on the same side.
    const int ab = side(p, q, t[0], t[1]), bc = side(p, q, t[1], t[2]),
              ca = side(p, q, t[2], t[0]);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
  }
  const IntPoint n = normal(t);
  const auto x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  const Plane2 plane{x >= y && x >= z ? 0 : y >= z ? 1 : 2};
  for (int i = 0; i < 3; ++i) {
    if (plane.cross(t[i], t[(i + 1) % 3], p, q)) return true;
  }
  const int ab = plane.turn(t[0], t[1], p), bc = plane.turn(t[1], t[2], p),
            ca = plane.turn(t[2], t[0], p);
  return ab == bc && bc == ca;  // wholly inside
}

/// The same mesh in integers and, times a unit, in doubles. A unit that is a power of
/// two makes both the same numbers.
struct IntMesh {
  std::vector<IntTriangle> triangles;  // those with area
  TriangleMesh mesh;
  double unit = 1;

  Eigen::Vector3d point(const IntPoint& p) const {
    return unit * Eigen::Vector3d(static_cast<double>(p.x), static_cast<double>(p.y),
                                  static_cast<double>(p.z));
  }
};

/// Rounds a mesh, `size` units large, to integers.
inline IntMesh rounded(const TriangleMesh& mesh, double size, double unit) {
  IntMesh result;
  result.unit = unit;
  std::vector<IntPoint> points;
  for (const Eigen::Vector3d& p : mesh.vertices) {
    points.push_back({std::llround(size * p.x()), std::llround(size * p.y()),
                      std::llround(size * p.z())});
    result.mesh.vertices.push_back(result.point(points.back()));
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    const IntTriangle t{points[a], points[b], points[c]};
    const IntPoint n = normal(t);
    if (n.x != 0 || n.y != 0 || n.z != 0) result.triangles.push_back(t);
  }
  result.mesh.triangles = mesh.triangles;
  return result;
}

class IntDraw {
 public:
  explicit IntDraw(std::uint64_t seed) : engine_(seed) {}
  std::int64_t between(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(engine_);
  }
  IntPoint point(std::int64_t reach) {
    return {between(-reach, reach), between(-reach, reach), between(-reach, reach)};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace delos::test
