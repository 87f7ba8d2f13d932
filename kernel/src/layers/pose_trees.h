// Poses sorted in space, so that what holds for many of them is asked once.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "delos/rig/system.h"

namespace delos {

/// A tree of boxes for each orientation that occurs. Poses stand in the order of the
/// leaves, each of which holds kLanes of them at most.
struct PoseTrees {
  struct Node {
    Eigen::AlignedBox3d box;           ///< of the target's positions
    std::uint32_t first = 0, end = 0;  ///< poses
    std::uint32_t below = 0;  ///< its children are this one and the next; 0: a leaf
  };

  explicit PoseTrees(std::span<const TargetPose> all);

  std::vector<TargetPose> poses;
  std::vector<std::int32_t> number;  ///< of each pose, as it was given
  std::vector<Node> nodes;
  std::vector<std::uint32_t> roots;  ///< of poses of one orientation each
};

}  // namespace delos
