// A device's parameters, read by its plugin's table.
#pragma once

#include "delos/device/parameters.h"
#include "delos/plugin.h"
#include "document/reader.h"

namespace delos {

/// Read the values that `params` gives and fill in the table's defaults.
/// @param device the device's mapping, in which `params` may be absent
void read_params(Reader& reader, const Place& device, const PluginInfo& info,
                 ParamValues& out);

[[nodiscard]] Node write_params(const ParamValues& params);

}  // namespace delos
