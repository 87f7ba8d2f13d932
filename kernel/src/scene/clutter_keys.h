// Bodies drawn at random: the keys of `clutter`.
#pragma once

#include <vector>

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

void read_clutter(Reader& reader, const Place& at, std::vector<ClutterEntry>& out);

[[nodiscard]] Node write_clutter(const std::vector<ClutterEntry>& clutter);

[[nodiscard]] Shape clutter_shape();

}  // namespace delos
