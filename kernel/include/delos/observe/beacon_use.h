// Which beacons the devices on a target see and use.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/rig/system.h"

namespace delos {

/// One beacon through one view of a device on the target.
struct SeenBeacon {
  std::string device;
  std::string view;
  Eigen::Vector3d at;   ///< the beacon, in W, metres
  double distance = 0;  ///< from the view's apex, metres
  double share = 0;     ///< how often an update uses it, in the mean; see SightingRule
};

/// All sightings at a pose, device by device and view by view.
[[nodiscard]] DELOS_API std::vector<SeenBeacon> seen_beacons(const System& system,
                                                             const TargetPose& pose);

/// How many beacons and views are used, in the mean over poses. Those that are only
/// seen don't count.
struct BeaconUse {
  double beacons = 0;    ///< different ones
  double views = 0;      ///< different ones
  double sightings = 0;  ///< beacons through views
};
/// @param threads 0: as many as OpenMP gives; the answer is the same
[[nodiscard]] DELOS_API BeaconUse beacon_use(const System& system,
                                             const std::vector<TargetPose>& poses,
                                             int threads = 0);

/// A sentence for each device on the target that sees no beacon at any of the poses:
/// what is in the way.
[[nodiscard]] DELOS_API std::vector<std::string> blind_devices(
    const System& system, const std::vector<TargetPose>& poses);

}  // namespace delos
