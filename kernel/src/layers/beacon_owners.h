// Whose the beacons are that a device sees.
#pragma once

#include <vector>

#include "delos/rig/system.h"
#include "delos/scene/candidates.h"

namespace delos {

/// The candidate of each beacon of a device's index, −1: none.
/// @pre the target carries the device, and `system` was built of all.scene
[[nodiscard]] std::vector<int> beacon_owners(const System& system,
                                             const PlacedDevice& placed,
                                             const CandidateScene& all);

}  // namespace delos
