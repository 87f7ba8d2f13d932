// Which sightings a device on the target uses in one update.
#pragma once

#include "observe/beacon_sightings.h"

namespace delos {

/// Set the share of every sighting by a rule, see SightingRule. A sighting of weight w
/// has at most the share w, but under `mean`.
/// @param order memory for it
void choose(SightingRule rule, int count, int coordinates, BeaconSightings& sightings,
            std::vector<std::uint32_t>& order);

}  // namespace delos
