// What hides, and named bodies: the keys of `occluders` and `regions`.
#pragma once

#include <vector>

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

void read_occluders(Reader& reader, const Place& at, std::vector<OccluderEntry>& out);
void read_regions(Reader& reader, const Place& at, std::vector<RegionEntry>& out);

[[nodiscard]] Node write_occluders(const std::vector<OccluderEntry>& occluders);
[[nodiscard]] Node write_regions(const std::vector<RegionEntry>& regions);

[[nodiscard]] Shape occluder_shape();
[[nodiscard]] Shape region_shape();

}  // namespace delos
