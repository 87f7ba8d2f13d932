// What measures: the keys of `devices` and `groups`.
#pragma once

#include <vector>

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

void read_groups(Reader& reader, const Place& at, std::vector<Group>& out);

/// Which parts of a scene have no findings, so that others can be compared with them.
struct Known {
  bool motion = false;
  bool surfaces = true;  ///< where there are none too
  bool beacons = true;   ///< likewise
};

/// Read the list of devices. Each is also made once, since its plugin may refuse values
/// that clash.
/// @param scene its motion, groups, surfaces and beacons have been read
void read_devices(Reader& reader, const Place& at, const Known& known, Scene& scene);

[[nodiscard]] Node write_groups(const std::vector<Group>& groups);
[[nodiscard]] Node write_devices(const std::vector<DeviceEntry>& devices);

[[nodiscard]] Shape group_shape();
[[nodiscard]] Shape device_shape();

}  // namespace delos
