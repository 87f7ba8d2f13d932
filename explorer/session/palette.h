// What can be put into a scene: a device of every plugin, and those that one can buy.
#pragma once

#include <string>

#include "delos/plugin/registry.h"
#include "delos/scene/presets.h"
#include "session/json.h"

namespace delos::session {

/// Parameters that a device of a plugin can begin with, as a YAML map: "{}" where its
/// table has a default for each; else the first of plugins/ID/example.yaml.
/// @returns empty where there is no such example
[[nodiscard]] std::string first_params(const PluginInfo& info);

/// The same of a device that one can buy, as device_presets() has it.
/// @returns empty where there is none of that name
[[nodiscard]] std::string preset_params(const std::string& type,
                                        const std::string& preset);

/// {types: [{id, summary, ready}], presets: [{name, type, source}]}
/// @param plugins those that can't be opened are left out
[[nodiscard]] Json palette_json(PluginRegistry& plugins);

}  // namespace delos::session
