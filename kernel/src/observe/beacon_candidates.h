// Beacons that a device may see from poses near each other.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "delos/rig/system.h"
#include "device/cone_test.h"

namespace delos {

/// A candidate that one of the poses has in a view's cone.
struct CandidateInCone {
  std::uint32_t candidate;
  std::uint32_t pose;  ///< of those that are asked for
};

/// Up to kLanes of them, as the device sees them and they see it.
struct BeaconLook {
  BeaconLanes lanes;
  std::uint32_t pose[kLanes];
  std::uint32_t beacon[kLanes];  ///< in the device's index
  double weight[kLanes];
  double distance[kLanes];  ///< from the view's apex, metres
  double reached[kLanes];   ///< 1: the beacon shines towards the apex; 0: it doesn't
};

/// What the views of a device on the target may see from any of some poses that are
/// turned alike and near each other: found once for all of them. What a pose sees is
/// the same whichever poses it is together with.
class BeaconCandidates {
 public:
  /// Find them for the first of the poses and for as many after it as pay.
  /// @param poses at least one
  /// @pre the target carries the device
  /// @returns how many poses
  std::size_t find(const PlacedDevice& placed, std::span<const TargetPose> poses);

  /// How many poses are worth asking about at once: a device answers of kLanes beacons
  /// as fast as of a few, but what many poses see fits into no cache.
  [[nodiscard]] std::size_t poses_together() const;

  /// Append those in a view's cone, in the order of the index.
  /// @param origin_S the world's origin as that pose sees it, R_SW (−p_WS)
  void append_in_cone(int view, std::uint32_t pose, const Eigen::Vector3d& origin_S,
                      std::vector<CandidateInCone>& found) const;

  /// @param candidates of this view, kLanes at most
  /// @param origins_S one a pose, as above
  void look(int view, std::span<const CandidateInCone> candidates,
            std::span<const Eigen::Vector3d> origins_S, BeaconLook& out) const;

  /// A view's cone, in S.
  [[nodiscard]] const ViewCone& cone(int view) const {
    return views_[static_cast<std::size_t>(view)].cone;
  }

 private:
  struct View {
    ViewCone cone;
    ConeTest test;
    std::uint32_t first, last;  // of the candidates
  };
  const BeaconIndex* index_ = nullptr;
  std::vector<View> views_;
  Eigen::Matrix3d R_SW_;
  std::vector<std::uint32_t> beacons_;  // those of all views, one view after the other
  std::vector<double> x_, y_, z_;       // their places R_SW b
};

}  // namespace delos
