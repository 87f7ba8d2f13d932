// Which readings a device may make of a target at a pose.
#pragma once

#include "observe/beacon_sightings.h"
#include "rig/sight.h"

namespace delos {

/// Visit what a device may read at an update: visit(view, of, share, without_sight),
/// with numbers as TrackReading has them and how much of an update a reading is, 1 but
/// for beacons and without sight.
template <class Visit>
void each_possible_reading(const System& system, const PlacedDevice& placed,
                           const TargetPose& X_WT, BeaconSearch& beacons,
                           Visit&& visit) {
  const TargetMount* carried = placed.carried();
  const bool may_hide = !carried && may_be_hidden(system, placed);
  if (placed.device->span() != Span::point) {
    if (may_hide && !in_sight(system, placed, X_WT, PlacedMarker())) return;
    visit(0, std::size_t{0}, 1.0, false);
  } else if (carried) {
    for (const BeaconSighting& s : beacons.see(system, placed, X_WT).all)
      if (s.share > 0) visit(s.view, std::size_t{s.beacon}, s.share, false);
  } else {
    for (std::size_t m = 0; m < system.markers.size(); ++m) {
      const bool hidden =
          may_hide && !in_sight(system, placed, X_WT, system.markers[m]);
      const double share = hidden ? placed.without_sight.probability : 1;
      if (share > 0) visit(0, m, share, hidden);
    }
  }
}

}  // namespace delos
