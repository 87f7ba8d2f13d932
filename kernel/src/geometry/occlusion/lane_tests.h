// Which boxes of a flat tree's node are to be entered, all of them at once.
#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geometry/occlusion/flat_tree.h"
#include "geometry/occlusion/float_bounds.h"
#include "geometry/occlusion/segment.h"

namespace delos {

/// One bit a lane of two halves whose lanes are all zeros or all ones.
inline unsigned lanes_of(const FlatNode::Words& first, const FlatNode::Words& second) {
  const FlatNode::Words bits = (first & FlatNode::Words{1, 2, 4, 8}) |
                               (second & FlatNode::Words{16, 32, 64, 128});
  const auto [low, high] = std::bit_cast<std::array<std::uint64_t, 2>>(bits);
  const std::uint64_t both = low | high;
  return static_cast<unsigned>(both | both >> 32) & 255;
}

/// Which boxes may overlap a box.
class OverlapTest {
 public:
  /// @param origin where the floats of the tree count from
  OverlapTest(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& origin) {
    for (int i = 0; i < 3; ++i) {
      min_[i] = float_below(box.min()[i] - origin[i]);
      max_[i] = float_above(box.max()[i] - origin[i]);
    }
  }

  /// @returns a bit for each lane
  unsigned operator()(const FlatNode& node) const {
    return lanes_of(half(node, 0), half(node, 1));
  }
  FlatNode::Words half(const FlatNode& node, int h) const {
    FlatNode::Words met = ~FlatNode::Words{};
    for (int i = 0; i < 3; ++i) {
      met &= (node.planes(0, i, h) <= max_[i]) & (node.planes(1, i, h) >= min_[i]);
    }
    return met;
  }

 private:
  std::array<float, 3> min_, max_;
};

/// Which boxes a segment may meet.
///
/// A segment a + t d, 0 ≤ t ≤ 1, is between the planes of a box for those t that are
/// between (near − a)/d and (far − a)/d on all axes. Says no only where it is certain.
class SlabTest {
 public:
  /// @param origin where the floats of the tree count from
  SlabTest(const Segment& s, const Eigen::Vector3d& origin) {
    for (int i = 0; i < 3; ++i) {
      const double a = s.a[i] - origin[i], d = s.b[i] - s.a[i];
      const bool rising = d >= 0;
      near_[i] = !rising;
      if (!(std::abs(a) < kFarthest && std::abs(d) < kFarthest)) {
        // Quotients that cut nothing off.
        near_[i] = 0;
        from_near_[i] = 1e31f, from_far_[i] = -1e31f, inverse_[i] = 1;
        continue;
      }
      from_near_[i] = rising ? float_above(a) : float_below(a);
      from_far_[i] = rising ? float_below(a) : float_above(a);
      // Of a segment within 1e-30 of a, the margin of floats takes care.
      inverse_[i] =
          static_cast<float>(std::abs(d) < 1e-30 ? std::copysign(1e30, d) : 1 / d);
    }
  }

  /// @returns a bit for each lane
  unsigned operator()(const FlatNode& node) const {
    return lanes_of(half(node, 0), half(node, 1));
  }

 private:
  FlatNode::Words half(const FlatNode& node, int h) const {
    using Floats = FlatNode::Floats;
    Floats enter{}, leave = Floats{} + 1;
    for (int i = 0; i < 3; ++i) {
      const Floats t = (node.planes(near_[i], i, h) - from_near_[i]) * inverse_[i];
      const Floats u = (node.planes(1 - near_[i], i, h) - from_far_[i]) * inverse_[i];
      enter = t > enter ? t : enter;
      leave = u < leave ? u : leave;
    }
    // Each quotient is off by three roundings, 1.8e-7 of itself.
    return enter <= leave * (1 + 1e-6f) + 1e-30f;
  }

  std::array<int, 3> near_;  // the side that is met first
  std::array<float, 3> from_near_, from_far_, inverse_;
};

}  // namespace delos
