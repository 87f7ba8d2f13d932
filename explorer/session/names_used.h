// Names of a scene's parts, and where other parts call them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "delos/scene/scene.h"
#include "session/json.h"

namespace delos::session {

/// What a text of a scene may name.
/// @param section a top-level key @param key that the text stands under, inside of it
/// @returns empty where any text will do
[[nodiscard]] std::vector<std::string> names_for(const Scene& scene, const Json& tree,
                                                 std::string_view section,
                                                 std::string_view key);

/// Call a part otherwise, where it stands and wherever it is named.
/// @param tree value_tree() @param section such as "regions"
void rename_part(Json& tree, const std::string& section, const std::string& from,
                 const std::string& to);

}  // namespace delos::session
