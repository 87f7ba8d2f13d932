#include "delos/device/beacons.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace delos {
namespace {

/// Beacons of a node that isn't split: about as many as are tested in the time that two
/// more nodes cost.
constexpr std::uint32_t kLeaf = 8;

/// What a cone asks of many points: without roots, which would be most of its cost.
struct ConeTest {
  explicit ConeTest(const ViewCone& cone)
      : apex(cone.apex),
        axis(cone.axis),
        range(cone.range),
        square_range(cone.range * cone.range),
        narrow(cone.half_angle < std::numbers::pi / 2),
        all_around(cone.half_angle >= std::numbers::pi),
        cosine(std::cos(cone.half_angle)),
        sine(std::sin(cone.half_angle)) {}

  /// False only where no point of the ball is in the cone.
  ///
  /// A point at depth a along the axis and s beside it is s cos θ − a sin θ away from
  /// the line through the apex along the cone's edge, and so at least as far from the
  /// cone itself where that is positive: outside where s cos θ > r + a sin θ.
  bool may_meet(const Eigen::Vector3d& center, double radius) const {
    const Eigen::Vector3d v = center - apex;
    const double square = v.squaredNorm();
    const double reach = range + radius;
    if (square > reach * reach) return false;
    if (!narrow) return true;
    const double a = v.dot(axis);
    const double beyond = radius + a * sine;
    if (beyond < 0) return false;
    // Rounding may not turn a touch into a certainty.
    const double s = square - a * a;
    return s * cosine * cosine <= beyond * beyond + 1e-12 * square;
  }

  /// Whether the angle to the axis is at most θ: cos θ |v| ≤ v·axis, by squares.
  bool contains(double x, double y, double z) const {
    const double vx = x - apex.x(), vy = y - apex.y(), vz = z - apex.z();
    const double square = vx * vx + vy * vy + vz * vz;
    const double a = vx * axis.x() + vy * axis.y() + vz * axis.z();
    const double edge = cosine * cosine * square;
    const bool in_angle =
        narrow ? (a >= 0) & (a * a >= edge) : all_around | (a >= 0) | (a * a <= edge);
    return in_angle & (square <= square_range);
  }

  Eigen::Vector3d apex, axis;
  double range, square_range;
  bool narrow, all_around;
  double cosine, sine;
};

}  // namespace

BeaconIndex::BeaconIndex(std::vector<Beacon> beacons) : listed_(beacons.size()) {
  std::iota(listed_.begin(), listed_.end(), 0);
  if (!beacons.empty()) {
    build(0, static_cast<std::uint32_t>(beacons.size()), beacons);
  }
  beacons_.reserve(beacons.size());
  for (const std::uint32_t i : listed_) {
    beacons_.push_back(beacons[i]);
    for (int c = 0; c < 3; ++c) p_[c].push_back(beacons[i].p[c]);
  }
}

/// Halves along the longest side, at the median; ties by the order of the list.
void BeaconIndex::build(std::uint32_t first, std::uint32_t last,
                        const std::vector<Beacon>& beacons) {
  Eigen::AlignedBox3d box;
  for (auto i = first; i < last; ++i) box.extend(beacons[listed_[i]].p);
  const std::size_t node = nodes_.size();
  // Rounding of the centre may leave a corner out by as much.
  const double radius = box.diagonal().norm() / 2 * (1 + 1e-12);
  nodes_.push_back({box.center(), radius, first, last, 0});
  if (last - first > kLeaf) {
    Eigen::Index axis;
    box.sizes().maxCoeff(&axis);
    const auto middle = first + (last - first) / 2;
    std::nth_element(listed_.begin() + first, listed_.begin() + middle,
                     listed_.begin() + last, [&](std::uint32_t a, std::uint32_t b) {
                       const double x = beacons[a].p[axis], y = beacons[b].p[axis];
                       return x != y ? x < y : a < b;
                     });
    build(first, middle, beacons);
    build(middle, last, beacons);
  }
  nodes_[node].next = static_cast<std::uint32_t>(nodes_.size());
}

void BeaconIndex::find(const ViewCone& cone, std::vector<std::uint32_t>& found) const {
  const ConeTest test(cone);
  for (std::uint32_t n = 0; n < nodes_.size();) {
    const Node& node = nodes_[n];
    const bool leaf = node.last - node.first <= kLeaf;
    if (!test.may_meet(node.center, node.radius)) {
      n = node.next;
      continue;
    }
    for (auto i = node.first; leaf && i < node.last; ++i) {
      if (test.contains(p_[0][i], p_[1][i], p_[2][i])) found.push_back(i);
    }
    ++n;
  }
}

}  // namespace delos
