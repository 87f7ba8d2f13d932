// How wide an imported camera sees, for people.
#pragma once

#include <string>

#include "delos/rig/system.h"

namespace delos::imports {

/// "43.1 x 33 deg" of a camera's image, "fisheye", or another device's type.
[[nodiscard]] std::string opening_text(const PlacedDevice& device);

}  // namespace delos::imports
