// Which of many poses a device sees, without asking it about each.
#pragma once

#include <cstdint>
#include <vector>

#include "layers/pose_trees.h"
#include "observe/measure.h"
#include "rig/sight.h"

namespace delos {

/// Sight lines from one place to a marker in all poses, each looked along once: devices
/// of one spot that face elsewhere share them.
struct SightsOfMarker {
  enum class Asked : std::uint8_t { no, yes };
  std::vector<Asked> asked;  ///< of each node
  std::vector<Sight> node;   ///< of each node, once asked
  std::vector<Sight> pose;   ///< of each pose in the trees' order
};

/// Asks devices of a system one after the other. One a thread.
///
/// Whole boxes of poses are told by Device::view_of_ball() and sight_of_box() to be in
/// view, out of it, clear or hidden; what remains is asked pose by pose.
class PoseViews {
 public:
  /// What is passed is kept by reference.
  PoseViews(const System& system, const PoseTrees& trees);

  /// Append the numbers of the poses in which a device sees any of the target,
  /// ascending.
  /// @pre the device stands in the world
  /// @throws DeviceFault
  void append(const PlacedDevice& placed, std::vector<std::int32_t>& poses);

 private:
  void see_any_span(const PlacedDevice& placed);
  void descend(const PlacedDevice& placed, std::uint32_t at, bool in_view, Sight sight);
  [[nodiscard]] View view_of(const PlacedDevice& placed,
                             const PoseTrees::Node& node) const;
  [[nodiscard]] Sight sight_of(const PlacedDevice& placed, std::uint32_t at);
  void see_block(const PlacedDevice& placed, const PoseTrees::Node& node, bool in_view,
                 Sight sight);
  [[nodiscard]] std::uint64_t in_view(const PlacedDevice& placed,
                                      std::span<const TargetPose> block);
  void note(std::uint32_t pose) {
    const auto i = static_cast<std::size_t>(trees_.number[pose]);
    seen_[i / 64] |= std::uint64_t{1} << (i % 64);
  }

  const System& system_;
  const PoseTrees& trees_;
  std::vector<SightsOfMarker> sights_;  // of each marker, from `place_`
  Eigen::Vector3d place_;               // NaN: nowhere yet
  std::vector<std::uint64_t> seen_;     // a bit a pose, as numbered
  MeasureScratch scratch_;
  // Of the walk through one tree.
  std::size_t marker_ = 0;
  Eigen::Vector3d arm_;      // from the target's origin to the marker, in W
  bool tells_balls_ = true;  // the device knows of whole balls
};

}  // namespace delos
