// Where the devices of a scene stand and what they look at, from above and from a side.
#pragma once

#include <string>

#include "delos/rig/system.h"

namespace delos::figures {

/// An SVG of two views to one scale: devices with their names, the cones that they see
/// up to half of the way to the samples, and the box around the samples, dashed.
/// Devices on the target are left out.
[[nodiscard]] std::string rig_figure(const Scene& scene, const System& system);

}  // namespace delos::figures
