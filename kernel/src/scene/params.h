// A device's parameters, read by its plugin's table.
#pragma once

#include "delos/device/parameters.h"
#include "delos/plugin.h"
#include "delos/scene/presets.h"
#include "document/reader.h"

namespace delos {

/// Read the values that `params` gives, and fill in those of a preset and the table's
/// defaults.
/// @param device the device's mapping, in which `params` may be absent
/// @param preset null: none
void read_params(Reader& reader, const Place& device, const PluginInfo& info,
                 const DevicePreset* preset, ParamValues& out);

[[nodiscard]] Node write_params(const ParamValues& params);

}  // namespace delos
