// What measures: the keys of `devices` and `groups`.
#pragma once

#include <vector>

#include "delos/scene/scene.h"
#include "scene/keys.h"

namespace delos {

void read_groups(Reader& reader, const Place& at, std::vector<Group>& out);

/// Read the list of devices. Each is also made once, since its plugin may refuse values
/// that clash.
/// @param motion_known false where `motion` has findings: state sizes aren't compared
/// then
/// @param scene its groups and motion have been read
void read_devices(Reader& reader, const Place& at, bool motion_known, Scene& scene);

[[nodiscard]] Node write_groups(const std::vector<Group>& groups);
[[nodiscard]] Node write_devices(const std::vector<DeviceEntry>& devices);

}  // namespace delos
