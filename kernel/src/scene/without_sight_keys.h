// The keys that say what becomes of readings without sight.
#pragma once

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

[[nodiscard]] std::vector<KeyShape> without_sight_keys();
void read_without_sight(Reader& reader, const Place& at, DeviceEntry& out);
[[nodiscard]] std::optional<Node> write_without_sight(const DeviceEntry& device);

/// Only of a device that sees points, each by itself, may something stand in the way.
void check_without_sight(Reader& reader, const Place& at, const DeviceEntry& entry,
                         const Device& device);

}  // namespace delos
