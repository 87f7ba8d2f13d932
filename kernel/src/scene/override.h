// Changes single values of a scene's tree by path, before the scene is checked.
#pragma once

#include "delos/scene/io.h"
#include "scene/findings.h"
#include "scene/yaml_tree.h"

namespace delos {

/// Replace or add the value at a path.
///
/// A path is keys joined by dots. Members of lists are called by their `name`, else by
/// index; components of coordinates by x, y, z (roll, pitch, yaw; w, x, y, z). A key
/// that is absent is added, and checked like any other; members of lists and of
/// `groups` aren't.
void apply_override(Node& root, const Override& change, Findings& findings);

}  // namespace delos
