#include "geometry/occlusion/clearance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace delos {
namespace {

using Vector = Eigen::Vector3d;

/// Levels of the tree; halves of the lower half of them hold any number of triangles.
constexpr int kDeepest = 64;

/// Where p + s·u and q + t·v, s and t in [0, 1], are nearest.
/// Source: Ericson (2005), Real-time collision detection, §5.1.9.
std::pair<double, double> nearest_parts(const Vector& p, const Vector& u,
                                        const Vector& q, const Vector& v) {
  const Vector r = p - q;
  const double a = u.squaredNorm(), e = v.squaredNorm();
  const double b = u.dot(v), c = u.dot(r), f = v.dot(r);
  const double denominator = a * e - b * b;
  double s = denominator > 1e-14 * a * e
                 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0)
                 : 0.0;
  double t = e > 0 ? (b * s + f) / e : 0.0;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = a > 0 ? std::clamp((b * t - c) / a, 0.0, 1.0) : 0.0;
  }
  return {s, t};
}

/// The nearest passage so far; its root is taken at the end.
struct Nearest {
  double square, part = 0;
  Vector difference = Vector::Zero();

  void take(double at, const Vector& from_triangle) {
    const double own = from_triangle.squaredNorm();
    if (own < square) *this = {own, at, from_triangle};
  }
};

/// A segment a + t·d, t in [0, 1], with what its tests against boxes share.
struct Probe {
  Vector a, d, inverse;

  Probe(const Vector& from, const Vector& to) : a(from), d(to - from) {
    // Finite, so that 0 times it is no NaN.
    for (int i = 0; i < 3; ++i) inverse[i] = std::abs(d[i]) < 1e-300 ? 1e300 : 1 / d[i];
  }

  /// Whether it may come so near to a box, by its part between the box's three pairs of
  /// planes, moved apart. Says no only where it doesn't.
  [[nodiscard]] bool may_pass(const Vector& min, const Vector& max,
                              double distance) const {
    double enter = 0, leave = 1;
    for (int i = 0; i < 3; ++i) {
      const double t = (min[i] - distance - a[i]) * inverse[i],
                   u = (max[i] + distance - a[i]) * inverse[i];
      enter = std::max(enter, std::min(t, u));
      leave = std::min(leave, std::max(t, u));
    }
    // Each product is off by four roundings at most.
    return enter <= leave * (1 + 3e-15);
  }
};

/// The nearest passage is from edge to segment, or from the inside of the triangle to
/// an end, or they meet.
void pass(const std::array<Vector, 3>& t, const Vector& normal, const Probe& segment,
          Nearest& best) {
  const Vector &a = segment.a, &d = segment.d;
  const double from = normal.dot(a - t[0]), along = normal.dot(d), to = from + along;
  const double square = normal.squaredNorm();
  // All of it is on one side of the plane and too far from it.
  const double least = std::min(std::abs(from), std::abs(to));
  if (from * to > 0 && least * least > best.square * square * (1 + 1e-12)) return;
  for (int i = 0; i < 3; ++i) {
    const Vector &q = t[static_cast<std::size_t>(i)],
                 v = t[static_cast<std::size_t>((i + 1) % 3)] - q;
    const auto [s, part] = nearest_parts(a, d, q, v);
    best.take(s, a + s * d - q - part * v);
  }
  if (square == 0) return;
  const auto inside = [&](const Vector& p) {
    for (int i = 0; i < 3; ++i) {
      const Vector &q = t[static_cast<std::size_t>(i)],
                   &r = t[static_cast<std::size_t>((i + 1) % 3)];
      if ((r - q).cross(p - q).dot(normal) < 0) return false;
    }
    return true;
  };
  if (from * from < best.square * square && inside(a))
    best.take(0, from / square * normal);
  if (to * to < best.square * square && inside(a + d))
    best.take(1, to / square * normal);
  if (from * to < 0 && inside(a - from / along * d))
    best.take(-from / along, Vector::Zero());
}

using Box = Eigen::AlignedBox3d;

Box box_of(const std::array<Vector, 3>& corners) {
  Box box(corners[0]);
  return box.extend(corners[1]).extend(corners[2]);
}

Vector middle_of(const std::array<Vector, 3>& corners) {
  return (corners[0] + corners[1] + corners[2]) / 3;
}

/// The chance that a sight line passes a box is as its surface.
double surface(const Box& box) {
  const Vector e = box.sizes();
  return e[0] * e[1] + e[1] * e[2] + e[2] * e[0];
}

/// Slices of equal thickness along an axis; which one a middle lies in.
struct Slices {
  static constexpr int kCount = 16;
  int axis = 0, cut = 0;  ///< the first slice of the second part
  double low = 0, size = 0;

  [[nodiscard]] int of(const Vector& middle) const {
    return std::min(kCount - 1, static_cast<int>((middle[axis] - low) / size * kCount));
  }
};

/// The cut of least surface times triangles, over both parts; size 0: there is none.
/// Source: Wald (2007), On fast construction of SAH-based bounding volume hierarchies.
template <class Triangles>
Slices best_cut(const Triangles& triangles, const Box& middles) {
  Slices best;
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    Slices slices{axis, 0, middles.min()[axis], middles.sizes()[axis]};
    if (!(slices.size > 0)) continue;
    std::array<Box, Slices::kCount> boxes;
    std::array<std::uint32_t, Slices::kCount> counts{};
    for (const auto& t : triangles) {
      const auto i = static_cast<std::size_t>(slices.of(middle_of(t.corners)));
      boxes[i].extend(box_of(t.corners));
      ++counts[i];
    }
    std::array<double, Slices::kCount> behind{};
    Box box;
    double count = 0;
    for (std::size_t i = Slices::kCount; i-- > 1;) {
      box.extend(boxes[i]);
      behind[i] = (count += counts[i]) > 0 ? count * surface(box) : 0;
    }
    box.setEmpty();
    count = 0;
    for (std::size_t i = 1; i < Slices::kCount; ++i) {
      box.extend(boxes[i - 1]);
      if ((count += counts[i - 1]) == 0 || behind[i] == 0) continue;
      const double cost = count * surface(box) + behind[i];
      if (cost >= least) continue;
      least = cost;
      best = slices;
      best.cut = static_cast<int>(i);
    }
  }
  return best;
}

}  // namespace

Clearance::Clearance(const std::vector<TriangleMesh>& parts) {
  for (const TriangleMesh& part : parts) {
    for (const auto& [i, j, k] : part.triangles) {
      const Vector &a = part.vertices[i], &b = part.vertices[j], &c = part.vertices[k];
      triangles_.push_back({{a, b, c}, (b - a).cross(c - a)});
    }
  }
  if (triangles_.empty()) return;
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(triangles_.size()), 0);
}

void Clearance::build(std::uint32_t node, std::uint32_t first, std::uint32_t count,
                      int depth) {
  constexpr std::uint32_t kLeaf = 2;
  Box box, middles;
  const std::span<Triangle> triangles(&triangles_[first], count);
  for (const Triangle& t : triangles) {
    box.extend(box_of(t.corners));
    middles.extend(middle_of(t.corners));
  }
  nodes_[node] = {box.min(), box.max(), first, count};
  if (count <= kLeaf) return;

  std::uint32_t cut = count / 2;
  const Slices best = best_cut(triangles, middles);
  if (best.size > 0 && depth < kDeepest / 2) {
    const auto second = std::partition(
        triangles.begin(), triangles.end(),
        [&](const Triangle& t) { return best.of(middle_of(t.corners)) < best.cut; });
    cut = static_cast<std::uint32_t>(second - triangles.begin());
  }
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node].first = children;
  nodes_[node].count = 0;
  build(children, first, cut, depth + 1);
  build(children + 1, first + cut, count - cut, depth + 1);
}

Passage Clearance::passage(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           double limit) const {
  Nearest best{limit * limit};
  if (nodes_.empty()) return {limit, 0, Vector::Zero()};
  const Probe segment(a, b);
  double distance = limit;
  std::uint32_t stack[kDeepest];
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[stack[--size]];
    if (!segment.may_pass(node.min, node.max, distance)) continue;
    if (node.count == 0) {
      stack[size++] = node.first + 1;
      stack[size++] = node.first;
      continue;
    }
    const double before = best.square;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      pass(triangles_[i].corners, triangles_[i].normal, segment, best);
    if (best.square < before) distance = std::sqrt(best.square);
  }
  return {distance, best.part,
          distance > 0 ? Vector(best.difference / distance) : Vector(Vector::Zero())};
}

}  // namespace delos
