// What a device on the target sees of the beacons in the world.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "delos/rig/system.h"
#include "observe/beacon_candidates.h"

namespace delos {

/// A row of a sighting over the pose coordinates, in W, with noise of its own.
struct SightingRow {
  double h[kMaxCoordinates];
  double variance;  ///< 0: perfect
};

/// One beacon through one view.
struct BeaconSighting {
  std::uint32_t beacon;  ///< in the device's index
  int view;
  double distance;          ///< from the view's apex, metres
  double weight;            ///< the beacon's
  double share;             ///< how often an update uses it, in the mean
  std::uint32_t first_row;  ///< of `rows` below
  std::uint32_t rows;
};

/// All sightings of one device at one pose.
struct BeaconSightings {
  std::vector<BeaconSighting> all;
  std::vector<SightingRow> rows;
};

/// Visit the rows of all sightings that an update uses: visit(sighting, row).
template <class Visit>
void each_used_row(const BeaconSightings& sightings, Visit&& visit) {
  for (const BeaconSighting& s : sightings.all) {
    if (s.share == 0) continue;
    for (std::uint32_t r = s.first_row; r < s.first_row + s.rows; ++r)
      visit(s, sightings.rows[r]);
  }
}

/// A view's cone, in W. @param X_WS the device on the target, in W
[[nodiscard]] ViewCone cone_in_world(const PlacedDevice& placed, int view,
                                     const Pose& X_WS);

/// Finds what devices on the target see of their beacons, and how often they use each.
/// One a thread: its memory is kept from one pose to the next.
class BeaconSearch {
 public:
  /// At each of some poses, in their order: visit(number of the pose, sightings), which
  /// hold until the next call. Poses that are near each other and turned alike are
  /// looked up, and the device is asked about their beacons, together.
  /// @pre the target carries the device
  /// @throws DeviceFault
  template <class Visit>
  void see_each(const System& system, const PlacedDevice& placed,
                std::span<const TargetPose> poses, Visit&& visit) {
    for (std::size_t first = 0; first < poses.size();) {
      const std::size_t end = first + candidates_.find(placed, poses.subspan(first));
      const std::size_t together = candidates_.poses_together();
      while (first < end) {
        const auto some = poses.subspan(first, std::min(together, end - first));
        for (const BeaconSightings& sightings : see_candidates(system, placed, some))
          visit(first++, sightings);
      }
    }
  }

  /// At one pose.
  const BeaconSightings& see(const System& system, const PlacedDevice& placed,
                             const TargetPose& X_WT) {
    candidates_.find(placed, {&X_WT, 1});
    return see_candidates(system, placed, {&X_WT, 1})[0];
  }

 private:
  struct Question;

  std::span<const BeaconSightings> see_candidates(const System& system,
                                                  const PlacedDevice& placed,
                                                  std::span<const TargetPose> poses);
  void look_through(const Question& question);
  void add_lanes(const Question& question);
  void add_singly(const Question& question);
  [[nodiscard]] bool in_light(const Question& question, int lane) const;
  [[nodiscard]] Eigen::Vector3d arm(const Question& question, int lane) const;
  template <class AppendRows>
  void append(const Question& question, int lane, AppendRows&& append_rows);
  void pull_lanes(const Question& question);

  BeaconCandidates candidates_;
  std::vector<Eigen::Vector3d> origins_;  // the world's, as each pose sees it
  std::vector<CandidateInCone> in_cone_;
  BeaconLook look_;
  RowLanes lane_rows_;
  double h_[kMaxLaneRows][kMaxCoordinates][kLanes];  // the same over the pose
  Target target_;
  Observation observation_;
  std::vector<BeaconSightings> sightings_;
  std::vector<std::uint32_t> order_;
};

/// S += Σ share·hᵀh/r over the rows with noise.
/// @param S packed as model/lanes.h says, one number an entry
/// @returns whether a row that is used has none
bool add_information(const BeaconSightings& sightings, int coordinates, double* S);

}  // namespace delos
