#include "delos/observe/beacon_use.h"

#include <algorithm>
#include <cstdint>

#include "delos/parallel/each.h"
#include "delos/text/numbers.h"
#include "observe/beacon_sightings.h"

namespace delos {
namespace {

/// Different values in a list, which is sorted on the way.
std::size_t distinct(std::vector<std::uint32_t>& values) {
  std::sort(values.begin(), values.end());
  return static_cast<std::size_t>(std::unique(values.begin(), values.end()) -
                                  values.begin());
}

/// The part of beacons in a view's cone that shine the other way, or not so far.
struct InCone {
  std::size_t all = 0, turned_away = 0;
};

InCone in_cones(const PlacedDevice& placed, const TargetPose& pose,
                std::vector<std::uint32_t>& in_cone) {
  InCone count;
  const TargetMount& mount = *placed.carried();
  const Pose X_WS = pose * mount.X_TS;
  for (int view = 0; view < placed.device->views(); ++view) {
    const ViewCone cone = cone_in_world(placed, view, X_WS);
    in_cone.clear();
    mount.beacons->find(cone, in_cone);
    count.all += in_cone.size();
    for (const std::uint32_t b : in_cone) {
      count.turned_away += !(*mount.beacons)[b].reaches(cone.apex);
    }
  }
  return count;
}

/// Why a device sees nothing from any of the poses.
std::string why_blind(const PlacedDevice& placed,
                      const std::vector<TargetPose>& poses) {
  const std::string sees_none = placed.name + " sees no beacon from any sample: ";
  const std::size_t lit = placed.carried()->beacons->size();
  if (lit == 0) return sees_none + "none is lit";
  InCone count;
  std::vector<std::uint32_t> in_cone;
  for (const TargetPose& pose : poses) {
    const InCone here = in_cones(placed, pose, in_cone);
    count.all += here.all;
    count.turned_away += here.turned_away;
  }
  if (count.all == 0) {
    return sees_none + "none of " + grouped(lit) +
           " is in a view's cone; look where the device and its views face";
  }
  if (count.turned_away == count.all) {
    return sees_none +
           "those in its views face away or are out of range; look at the beacons' "
           "normal, emission and range";
  }
  return sees_none + "those in its views are hidden, or weigh nothing";
}

}  // namespace

std::vector<SeenBeacon> seen_beacons(const System& system, const TargetPose& pose) {
  std::vector<SeenBeacon> all;
  BeaconSearch search;
  for (const PlacedDevice& placed : system.devices) {
    if (!placed.sees_beacons()) continue;
    for (const BeaconSighting& s : search.see(system, placed, pose).all) {
      all.push_back({placed.name, placed.device->view_name(s.view),
                     (*placed.carried()->beacons)[s.beacon].p, s.distance, s.share});
    }
  }
  return all;
}

BeaconUse beacon_use(const System& system, const std::vector<TargetPose>& poses,
                     int threads) {
  std::atomic<std::size_t> beacons = 0, views = 0, sightings = 0;
  each_with(poses.size(), {.threads = threads, .grain = 16}, [&] {
    return [&, search = BeaconSearch(), used = std::vector<std::uint32_t>(),
            through = std::vector<std::uint32_t>()](std::size_t i) mutable {
      for (const PlacedDevice& placed : system.devices) {
        if (!placed.sees_beacons()) continue;
        used.clear();
        through.clear();
        for (const BeaconSighting& s : search.see(system, placed, poses[i]).all) {
          if (s.share == 0) continue;
          used.push_back(s.beacon);
          through.push_back(static_cast<std::uint32_t>(s.view));
        }
        sightings += used.size();
        beacons += distinct(used);
        views += distinct(through);
      }
    };
  });
  const auto mean = [&](std::size_t sum) {
    return poses.empty() ? 0.0
                         : static_cast<double>(sum) / static_cast<double>(poses.size());
  };
  return {mean(beacons), mean(views), mean(sightings)};
}

std::vector<std::string> blind_devices(const System& system,
                                       const std::vector<TargetPose>& poses) {
  std::vector<std::string> reasons;
  BeaconSearch search;
  for (const PlacedDevice& placed : system.devices) {
    if (!placed.sees_beacons()) continue;
    const bool blind =
        std::none_of(poses.begin(), poses.end(), [&](const TargetPose& pose) {
          return !search.see(system, placed, pose).all.empty();
        });
    if (blind) reasons.push_back(why_blind(placed, poses));
  }
  return reasons;
}

}  // namespace delos
