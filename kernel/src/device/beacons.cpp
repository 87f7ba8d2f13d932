#include "delos/device/beacons.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>

#include "device/cone_test.h"

namespace delos {
namespace {

constexpr std::uint32_t kFan = BeaconIndex::kFan;

/// Four lanes side by side, by the compiler's vector extension.
using Floats = float __attribute__((vector_size(16)));
using Words = std::int32_t __attribute__((vector_size(16)));

/// What a cone of less than a right angle asks of balls, eight side by side.
///
/// A point at depth a along the axis and s beside it is s cos θ − a sin θ away from the
/// line through the apex along the cone's edge, and so at least as far from the cone
/// itself where that is positive. A ball meets the cone only where s cos θ ≤ r + a sin
/// θ. Squares do without roots; single precision does with half of the memory, which is
/// most of the cost, and with margins that keep every ball that might meet.
struct NarrowCone {
  /// @param extent greatest coordinate of the beacons, metres
  /// @param near balls so far from the cone count as meeting it, metres
  NarrowCone(const ViewCone& cone, double extent, double near)
      : apex(cone.apex.cast<float>()),
        axis(cone.axis.cast<float>()),
        sine(static_cast<float>(std::sin(cone.half_angle))),
        square_cosine(static_cast<float>(std::pow(std::cos(cone.half_angle), 2))),
        range(static_cast<float>(std::min(cone.range, 1e15))),
        margin(static_cast<float>(
            near + 1e-6 * (near + extent + cone.apex.cwiseAbs().maxCoeff()))) {}

  /// A bit for each ball that may meet the cone.
  [[nodiscard]] unsigned meeting(const BeaconIndex::Balls& balls) const {
    const Words bits = (half(balls, 0) & Words{1, 2, 4, 8}) |
                       (half(balls, 4) & Words{16, 32, 64, 128});
    const auto [low, high] = std::bit_cast<std::array<std::uint64_t, 2>>(bits);
    const std::uint64_t both = low | high;
    return static_cast<unsigned>(both | both >> 32) & 255;
  }

  /// Lanes of all ones for those of four balls that may meet the cone.
  [[nodiscard]] Words half(const BeaconIndex::Balls& balls, int first) const {
    constexpr float kRounding = 1e-5f;  // of squared distances
    const auto four = [first](const float* all) {
      Floats some;
      std::memcpy(&some, all + first, sizeof some);
      return some;
    };
    const Floats x = four(balls.x) - apex.x();
    const Floats y = four(balls.y) - apex.y();
    const Floats z = four(balls.z) - apex.z();
    const Floats r = four(balls.radius) + margin;
    const Floats square = x * x + y * y + z * z;
    const Floats a = x * axis.x() + y * axis.y() + z * axis.z();
    const Floats beyond = r + a * sine, reach = (range + r) * (1 + kRounding);
    const Floats aside = (square - a * a) * square_cosine - kRounding * square;
    return (beyond >= 0) & (aside <= beyond * beyond) & (square <= reach * reach) &
           (r >= 0);
  }

  Eigen::Vector3f apex, axis;
  float sine, square_cosine, range, margin;
};

/// Visit the beacons that may meet a cone, in the order of the index.
template <class Visit>
void descend(const std::vector<std::vector<BeaconIndex::Balls>>& levels,
             const NarrowCone& cone, std::size_t level, std::size_t group,
             Visit&& visit) {
  for (unsigned bits = cone.meeting(levels[level][group]); bits != 0;
       bits &= bits - 1) {
    const std::size_t i =
        group * kFan + static_cast<std::size_t>(std::countr_zero(bits));
    if (level == 0) {
      visit(static_cast<std::uint32_t>(i));
    } else {
      descend(levels, cone, level - 1, i, visit);
    }
  }
}

}  // namespace

BeaconIndex::BeaconIndex(std::vector<Beacon> beacons) : listed_(beacons.size()) {
  std::iota(listed_.begin(), listed_.end(), 0);
  std::size_t size = kFan;
  while (size < beacons.size()) size *= kFan;
  sort(0, beacons.size(), size, beacons);
  beacons_.reserve(beacons.size());
  for (const std::uint32_t i : listed_) beacons_.push_back(beacons[i]);
  if (!beacons_.empty()) stack();
}

/// Put runs of size/8, size/64, … beacons side by side: halved three times along the
/// longest side of what is halved; ties by the order of the list.
void BeaconIndex::sort(std::size_t first, std::size_t last, std::size_t size,
                       const std::vector<Beacon>& beacons) {
  if (size <= kFan || last - first <= 1) return;
  const auto at = [&](std::size_t i) {
    return listed_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const auto halve = [&](auto&& self, std::size_t begin, std::size_t end,
                         std::size_t part) -> void {
    if (part == size / kFan) return sort(begin, end, part, beacons);
    const std::size_t middle = std::min(begin + part / 2, end);
    Eigen::AlignedBox3d box;
    for (std::size_t i = begin; i < end; ++i) box.extend(beacons[listed_[i]].p);
    Eigen::Index axis = 0;
    if (middle < end) {
      box.sizes().maxCoeff(&axis);
      std::nth_element(at(begin), at(middle), at(end),
                       [&](std::uint32_t a, std::uint32_t b) {
                         const double x = beacons[a].p[axis], y = beacons[b].p[axis];
                         return x != y ? x < y : a < b;
                       });
    }
    self(self, begin, middle, part / 2);
    if (middle < end) self(self, middle, end, part / 2);
  };
  halve(halve, first, last, size);
}

/// Balls around eight beacons each, around eight of those balls, and so on to one
/// group.
void BeaconIndex::stack() {
  for (std::size_t run = 1;; run *= kFan) {
    std::vector<Balls>& level = levels_.emplace_back();
    const std::size_t count = (beacons_.size() + run - 1) / run;
    level.resize((count + kFan - 1) / kFan);
    for (std::size_t i = 0; i < level.size() * kFan; ++i) {
      const std::size_t first = i * run;
      const std::size_t last = std::min(first + run, beacons_.size());
      Eigen::AlignedBox3d box;
      for (std::size_t b = first; b < last; ++b) box.extend(beacons_[b].p);
      Balls& balls = level[i / kFan];
      const std::size_t l = i % kFan;
      if (first >= last) {
        balls.x[l] = balls.y[l] = balls.z[l] = 0;
        balls.radius[l] = -std::numeric_limits<float>::max();
        continue;
      }
      double radius = 0;
      for (std::size_t b = first; b < last; ++b) {
        radius = std::max(radius, (beacons_[b].p - box.center()).norm());
      }
      balls.x[l] = static_cast<float>(box.center().x());
      balls.y[l] = static_cast<float>(box.center().y());
      balls.z[l] = static_cast<float>(box.center().z());
      balls.radius[l] = static_cast<float>(radius);
      extent_ = std::max(
          {extent_, box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()});
      if (run == kFan) patch_ += radius / static_cast<double>(count);
    }
    if (level.size() == 1) return;
  }
}

void BeaconIndex::find(const ViewCone& cone, std::vector<std::uint32_t>& found) const {
  const std::size_t first = found.size();
  find_near(cone, 0, found);
  const ConeTest test(cone);
  const auto outside = [&](std::uint32_t i) {
    const Eigen::Vector3d way = beacons_[i].p - cone.apex;
    return !test.holds(way.dot(cone.axis), way.squaredNorm());
  };
  found.erase(std::remove_if(found.begin() + static_cast<std::ptrdiff_t>(first),
                             found.end(), outside),
              found.end());
}

void BeaconIndex::find_near(const ViewCone& cone, double metres,
                            std::vector<std::uint32_t>& found) const {
  if (cone.half_angle >= std::numbers::pi / 2) {
    for (std::size_t i = 0; i < beacons_.size(); ++i) {
      found.push_back(static_cast<std::uint32_t>(i));
    }
    return;
  }
  if (levels_.empty()) return;
  descend(levels_, NarrowCone(cone, extent_, metres), levels_.size() - 1, 0,
          [&](std::uint32_t i) { found.push_back(i); });
}

}  // namespace delos
