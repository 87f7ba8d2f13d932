// What there is to search for in a scene, and how it is changed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "delos/document/override.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// {variables: [{path, unit, value, lower, upper, logarithmic, followers}],
///  objective: {name, unit}, constraints: [{name, limit, unit}],
///  selection: null, count, budget or cover}
[[nodiscard]] Json search_task(const LoadedScene& loaded, PluginRegistry& plugins);

/// The changes that make numbers variables, or give variables other bounds.
/// @param path  as `variables` writes it, patterns too
/// @param lower a quantity as scenes write it; nullopt: what is known of the number,
///              else the bounds of the room
/// @throws std::invalid_argument there is no such number, or its bounds contradict
[[nodiscard]] std::vector<Override> varying(const LoadedScene& loaded,
                                            const std::string& path,
                                            const std::optional<std::string>& lower,
                                            const std::optional<std::string>& upper,
                                            PluginRegistry& plugins);
/// The changes after which they aren't variables any more.
/// @throws std::invalid_argument none of them is one
[[nodiscard]] std::vector<Override> fixing(const LoadedScene& loaded,
                                           const std::string& path,
                                           PluginRegistry& plugins);

}  // namespace delos::session
