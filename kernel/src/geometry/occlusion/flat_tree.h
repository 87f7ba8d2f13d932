// A tree of boxes, flat in memory: what a walk reads next is what lies next.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace delos {

/// Up to eight boxes side by side in two lines of memory. Their planes are whole steps
/// away from the least corner of all, rounded outward.
struct alignas(64) FlatNode {
  static constexpr int kLanes = 8, kHalves = 2;
  using Floats [[gnu::vector_size(16)]] = float;  ///< of half the lanes
  using Words [[gnu::vector_size(16)]] = std::int32_t;
  static constexpr int kBits = 10;                  ///< of a plane
  static constexpr int kMost = (1 << kBits) - 1;    ///< steps
  static constexpr std::uint32_t kItem = 1u << 31;  ///< the child is an item

  std::array<float, 3> corner;
  std::array<std::uint8_t, 3> exponent;  ///< of the step, as floats have it
  std::uint8_t lanes;                    ///< a bit for each that has a child
  std::array<std::array<Words, kHalves>, 2> packed;  ///< least planes, greatest planes
  std::array<std::uint32_t, kLanes> child;

  float step(int axis) const {
    return std::bit_cast<float>(std::uint32_t{exponent[axis]} << 23);
  }
  /// Where the boxes begin (side 0) and end (side 1) along an axis.
  Floats planes(int side, int axis, int half) const {
    const Words steps = packed[side][half] >> (kBits * axis) & kMost;
    return corner[axis] + __builtin_convertvector(steps, Floats) * step(axis);
  }
};

/// Ask for two lines of memory that will be read soon.
template <class T>
void prefetch(const T& here) {
  __builtin_prefetch(&here);
  __builtin_prefetch(reinterpret_cast<const char*>(&here) + 64);
}

/// Boxes, called items, by nodes in depth-first order.
class FlatTree {
 public:
  using Box = Eigen::AlignedBox3d;

  FlatTree() = default;
  /// @pre fewer than 2³¹ boxes, none empty
  /// @cost n log n
  explicit FlatTree(std::span<const Box> boxes);

  /// Which box is the i-th item: neighbours in space are so in number.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  /// Where the floats count from, so that far-away coordinates lose no digits.
  [[nodiscard]] const Eigen::Vector3d& origin() const { return origin_; }
  /// Calls visit(item), until it returns true, for each item whose box enter() accepts;
  /// visit.prefetch(item) as soon as that is known.
  /// @param enter gets a node and returns a bit for each lane to enter
  template <class Enter, class Visit>
  void walk(const Enter& enter, const Visit& visit) const;

 private:
  /// Every node has at least two children, and halves, where nothing else does.
  static constexpr int kMostLevels = 64;

  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::vector<FlatNode> nodes_;
  std::vector<std::uint32_t> order_;
};

template <class Enter, class Visit>
void FlatTree::walk(const Enter& enter, const Visit& visit) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, kMostLevels*(FlatNode::kLanes - 1) + 1> open;
  open[0] = 0;
  for (int count = 1; count > 0;) {
    const std::uint32_t next = open[--count];
    if (next & FlatNode::kItem) {
      if (visit(next ^ FlatNode::kItem)) return;
      continue;
    }
    const FlatNode& node = nodes_[next];
    for (unsigned lanes = enter(node) & node.lanes; lanes != 0; lanes &= lanes - 1) {
      const std::uint32_t child = node.child[std::countr_zero(lanes)];
      open[count++] = child;
      // Walking waits for memory more than for anything else: ask early.
      if (child & FlatNode::kItem) {
        visit.prefetch(child ^ FlatNode::kItem);
      } else {
        prefetch(nodes_[child]);
      }
    }
  }
}

}  // namespace delos
