#include "geometry/clearance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace delos {
namespace {

using Vector = Eigen::Vector3d;

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

void take(double part, const Vector& difference, Passage& best) {
  const double distance = difference.norm();
  if (distance < best.distance)
    best = {distance, part,
            distance > 0 ? Vector(difference / distance) : Vector(Vector::Zero())};
}

/// The nearest passage is from edge to segment, or from the inside of the triangle to
/// an end, or they meet.
void pass(const std::array<Vector, 3>& t, const Vector& a, const Vector& d,
          Passage& best) {
  for (int i = 0; i < 3; ++i) {
    const Vector &q = t[static_cast<std::size_t>(i)],
                 v = t[static_cast<std::size_t>((i + 1) % 3)] - q;
    const auto [s, along] = nearest_parts(a, d, q, v);
    take(s, a + s * d - q - along * v, best);
  }
  const Vector normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double square = normal.squaredNorm();
  if (square == 0) return;
  const auto inside = [&](const Vector& p) {
    for (int i = 0; i < 3; ++i) {
      const Vector &q = t[static_cast<std::size_t>(i)],
                   &r = t[static_cast<std::size_t>((i + 1) % 3)];
      if ((r - q).cross(p - q).dot(normal) < 0) return false;
    }
    return true;
  };
  const double from = normal.dot(a - t[0]), to = normal.dot(a + d - t[0]);
  if (inside(a)) take(0, from / square * normal, best);
  if (inside(a + d)) take(1, to / square * normal, best);
  if (from * to < 0 && inside(a + from / (from - to) * d))
    take(from / (from - to), Vector::Zero(), best);
}

/// Whether a + t·d, t in [0, 1], may meet a box, by its part between the box's three
/// pairs of planes. Says no only where it doesn't.
bool may_meet(const Vector& a, const Vector& d, const Vector& low, const Vector& high) {
  double enter = 0, leave = 1;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(d[i]) < 1e-300) {
      if (a[i] < low[i] || a[i] > high[i]) return false;
      continue;
    }
    const double t = (low[i] - a[i]) / d[i], u = (high[i] - a[i]) / d[i];
    enter = std::max(enter, std::min(t, u));
    leave = std::min(leave, std::max(t, u));
  }
  // Each quotient is off by three roundings at most.
  return enter <= leave * (1 + 2e-15);
}

}  // namespace

Clearance::Clearance(const std::vector<TriangleMesh>& parts) {
  for (const TriangleMesh& part : parts) {
    for (const auto& [i, j, k] : part.triangles)
      triangles_.push_back({part.vertices[i], part.vertices[j], part.vertices[k]});
  }
  if (triangles_.empty()) return;
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(triangles_.size()));
}

void Clearance::build(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  constexpr std::uint32_t kLeaf = 4;
  Eigen::AlignedBox3d box, middles;
  const auto begin = triangles_.begin() + first, end = begin + count;
  for (auto t = begin; t != end; ++t) {
    for (const Vector& corner : *t) box.extend(corner);
    middles.extend(((*t)[0] + (*t)[1] + (*t)[2]) / 3);
  }
  nodes_[node] = {box.min(), box.max(), first, count};
  if (count <= kLeaf) return;

  // Halve at the median of the longest side.
  Eigen::Index axis = 0;
  middles.sizes().maxCoeff(&axis);
  const auto middle = [axis](const Triangle& t) {
    return t[0](axis) + t[1](axis) + t[2](axis);
  };
  std::nth_element(
      begin, begin + count / 2, end,
      [&](const Triangle& s, const Triangle& t) { return middle(s) < middle(t); });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node].first = children;
  nodes_[node].count = 0;
  build(children, first, count / 2);
  build(children + 1, first + count / 2, count - count / 2);
}

Passage Clearance::passage(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           double limit) const {
  Passage best;
  best.distance = limit;
  if (nodes_.empty()) return best;
  // Halving by medians: 64 levels hold any number of triangles.
  std::uint32_t stack[64];
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[stack[--size]];
    const Vector low = node.min.array() - best.distance,
                 high = node.max.array() + best.distance;
    if (!may_meet(a, b - a, low, high)) continue;
    if (node.count == 0) {
      stack[size++] = node.first + 1;
      stack[size++] = node.first;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      pass(triangles_[i], a, b - a, best);
  }
  return best;
}

}  // namespace delos
