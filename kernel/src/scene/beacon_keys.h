// What devices on the target look at: the keys of `beacons`.
#pragma once

#include <vector>

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

void read_beacons(Reader& reader, const Place& at, std::vector<BeaconSet>& out);

[[nodiscard]] Node write_beacons(const std::vector<BeaconSet>& beacons);

[[nodiscard]] Shape beacon_set_shape();

}  // namespace delos
