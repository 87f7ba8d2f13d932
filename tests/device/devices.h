// Makes devices for tests, by id and with parameters as YAML.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "delos/plugin/registry.h"

namespace delos::test {

/// 13 m from a device at the origin: 3² + 4² + 12² = 13².
inline const Target kThirteenAway{.p_ST = {3, 4, 12}, .state = {}};

/// The registry of this program, in which libraries are found once.
PluginRegistry& registry();

/// The plugin; a failed expectation with its error where it can't be used.
const PluginInfo* plugin(const std::string& id);

/// All parameters in SI units: those of the YAML map, else the table's defaults.
/// @throws std::runtime_error for a key that isn't in the table, or a value that's
/// missing
ParamValues values(const PluginInfo& info, const std::string& yaml);

/// The device; throws what its constructor throws.
std::shared_ptr<const Device> device(const std::string& id, const std::string& yaml);

/// What the constructor refuses the parameters for; "accepted" where it doesn't.
std::string refusal(const std::string& id, const std::string& yaml);

/// Ids of all devices: those of this build, and what else lies in the plugin folders.
std::vector<std::string> all_ids();

/// Parameters that show the device, a YAML map each: plugins/<id>/example.yaml, or only
/// the defaults where there is no such file.
std::vector<std::string> examples(const std::string& id);

}  // namespace delos::test
