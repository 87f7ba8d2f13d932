// Changes single values of a scene's tree by path, before the scene is checked.
#pragma once

#include <optional>
#include <string>

#include "delos/document/override.h"
#include "document/findings.h"
#include "document/yaml_tree.h"

namespace delos {

/// Replace or add the value at a path.
///
/// @param where what findings about the path point at
///
/// A path is keys joined by dots. Members of lists are called by their `name`, else by
/// index; components of coordinates by x, y, z (roll, pitch, yaw; w, x, y, z); `*`
/// before the last means all members there. A key that is absent is added, and checked
/// like any other; members of lists aren't, nor is a value within a group, a surface or
/// a region that there isn't. `+` after a list adds a member;
/// `-` takes the one away whose name or index is the value; of a mapping, the key.
void replace_value(Node& root, const std::string& path, Node value, Mark where,
                   Findings& findings);

/// The same with a value in YAML; findings are located as "--set PATH".
void apply_override(Node& root, const Override& change, Findings& findings);

/// Where the value at a path is; nullopt where the text has none.
[[nodiscard]] std::optional<Mark> mark_at(Node root, const std::string& path);

}  // namespace delos
