// What in a scene is hardly meant: devices that see nothing, bodies that hold all,
// values of the wrong unit.
#pragma once

#include <vector>

#include "delos/api.h"
#include "delos/document/diagnostic.h"
#include "delos/rig/system.h"
#include "delos/scene/scene.h"

namespace delos {

class PluginRegistry;

/// What to ask the user about a scene that is in order: a look at a thousand of its
/// places, or fewer where there are many devices, tells
///
///   - a device that sees none of them, or less than one in a hundred, and why;
///   - a device whose view is narrower than a degree;
///   - a device a thousand times as far away as the samples are wide, and samples that
///     are a hundred times as wide as the devices are apart, where a thousandth of that
///     would be ordinary;
///   - a body that holds all places or all devices.
///
/// What may be meant instead is tried before it is named: degrees for radians,
/// millimetres for metres.
/// @param plugins of the scene's devices, to make them with other parameters
/// @pre system was built of the scene
[[nodiscard]] DELOS_API std::vector<Remark> doubts(const Scene& scene,
                                                   const System& system,
                                                   PluginRegistry& plugins);

}  // namespace delos
