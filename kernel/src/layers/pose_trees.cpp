#include "layers/pose_trees.h"

#include <algorithm>
#include <array>
#include <map>

#include "delos/model/lanes.h"

namespace delos {
namespace {

/// Halves lists of poses until they fit into a block.
class PoseSplitter {
 public:
  PoseSplitter(std::span<const TargetPose> poses, std::vector<std::int32_t>& number,
               std::vector<PoseTrees::Node>& nodes)
      : poses_(poses), number_(number), nodes_(nodes) {}

  void fill(std::uint32_t node, std::uint32_t first, std::uint32_t end) {
    Eigen::AlignedBox3d box;
    for (std::uint32_t i = first; i < end; ++i) box.extend(place(number_[i]));
    nodes_[node] = {box, first, end, 0};
    if (end - first <= kLanes) return;
    // Whole blocks on the left.
    const std::uint32_t middle =
        first + (((end - first) / 2 + kLanes - 1) / kLanes) * kLanes;
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const auto at = [&](std::uint32_t i) { return number_.begin() + i; };
    std::nth_element(at(first), at(middle), at(end),
                     [&](std::int32_t a, std::int32_t b) {
                       const double x = place(a)(axis), y = place(b)(axis);
                       return x != y ? x < y : a < b;
                     });
    const auto below = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].below = below;
    nodes_.resize(nodes_.size() + 2);
    fill(below, first, middle);
    fill(below + 1, middle, end);
  }

 private:
  [[nodiscard]] const Eigen::Vector3d& place(std::int32_t pose) const {
    return poses_[static_cast<std::size_t>(pose)].p;
  }

  std::span<const TargetPose> poses_;
  std::vector<std::int32_t>& number_;
  std::vector<PoseTrees::Node>& nodes_;
};

}  // namespace

PoseTrees::PoseTrees(std::span<const TargetPose> all) {
  std::map<std::array<double, 9>, std::vector<std::int32_t>> of_orientation;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::array<double, 9> R{};
    std::copy_n(all[i].R.data(), 9, R.begin());
    of_orientation[R].push_back(static_cast<std::int32_t>(i));
  }
  number.reserve(all.size());
  PoseSplitter splitter(all, number, nodes);
  for (const auto& [R, own] : of_orientation) {
    const auto first = static_cast<std::uint32_t>(number.size());
    number.insert(number.end(), own.begin(), own.end());
    roots.push_back(static_cast<std::uint32_t>(nodes.size()));
    nodes.emplace_back();
    splitter.fill(roots.back(), first, static_cast<std::uint32_t>(number.size()));
  }
  poses.reserve(all.size());
  for (const std::int32_t i : number) poses.push_back(all[static_cast<std::size_t>(i)]);
}

}  // namespace delos
