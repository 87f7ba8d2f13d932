// What a device on the target sees of the beacons in the world.
#pragma once

#include <cstdint>
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

/// All sightings of one device at one pose. Memory is kept from one pose to the next.
struct BeaconSightings {
  std::vector<BeaconSighting> all;
  std::vector<SightingRow> rows;

  BeaconCandidates candidates;
  std::vector<std::uint32_t> in_cone;
  BeaconLook look;
  RowLanes lane_rows;
  Target target;
  Observation observation;
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

/// Find what the device sees of its beacons from the pose, and how often it uses each.
/// @pre the target carries it
void see_beacons(const System& system, const PlacedDevice& placed,
                 const TargetPose& X_WT, BeaconSightings& out);
/// The same at one of the poses that out.candidates was made for.
void see_candidates(const System& system, const PlacedDevice& placed,
                    const TargetPose& X_WT, BeaconSightings& out);

/// S += Σ share·hᵀh/r over the rows with noise.
/// @param S packed as model/lanes.h says, one number an entry
/// @returns whether a row that is used has none
bool add_information(const BeaconSightings& sightings, int coordinates, double* S);

}  // namespace delos
