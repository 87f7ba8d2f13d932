// A scene's text as values, for forms that show it.
#pragma once

#include <string>
#include <vector>

#include "delos/scene/scene.h"
#include "session/json.h"

namespace delos::session {

/// A scene as write_scene() writes it: mappings, lists, and texts for single values.
[[nodiscard]] Json value_tree(const Scene& scene);

/// "occluders.table.at" → "occluders", "table", "at"
[[nodiscard]] std::vector<std::string> segments_of(const std::string& path);

/// What paths call a member of a list: its `name` where it has one, else its index.
[[nodiscard]] std::string member_name(const Json& list, std::size_t index);

/// The value at a path of such names and keys; null where there is none.
[[nodiscard]] const Json* value_at(const Json& tree, const std::string& path);

}  // namespace delos::session
