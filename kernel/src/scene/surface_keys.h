// Where devices are mounted: the keys of `surfaces`, and `on` and `coordinates` of
// devices.
#pragma once

#include <vector>

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

void read_surfaces(Reader& reader, const Place& at, std::vector<SurfaceEntry>& out);

[[nodiscard]] Node write_surfaces(const std::vector<SurfaceEntry>& surfaces);

void read_on(Reader& reader, const Place& at, DeviceEntry& out);
void read_coordinates(Reader& reader, const Place& at, DeviceEntry& out);

[[nodiscard]] std::optional<Node> write_on(const DeviceEntry& device);
[[nodiscard]] std::optional<Node> write_coordinates(const DeviceEntry& device);

/// What only the keys together and the surfaces tell.
/// @param surfaces null where they have findings
/// @returns the point that the device is mounted on; nullopt where it has findings or
///          isn't mounted
std::optional<MountPoint> check_mounting(Reader& reader, const Place& at,
                                         const DeviceEntry& device,
                                         const std::vector<SurfaceEntry>* surfaces);

[[nodiscard]] Shape surface_shape();

}  // namespace delos
