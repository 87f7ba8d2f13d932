// How the clocks of devices drift: the keys of `clocks`.
#pragma once

#include <vector>

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

void read_clocks(Reader& reader, const Place& at, std::vector<ClockEntry>& out);

/// Not every fusion knows of clocks that are unknown anew at each update, and clocks
/// are of devices.
void check_clocks(Reader& reader, const Place& root, const Scene& scene);

[[nodiscard]] Node write_clocks(const std::vector<ClockEntry>& clocks);

[[nodiscard]] Shape clock_shape();

}  // namespace delos
