// What the text of a scene may look like, from the tables that read it.
#pragma once

#include "delos/api.h"
#include "delos/document/shape.h"

namespace delos {

/// A whole scene, or one that extends another.
///
/// What only several values together tell, such as a name that something else must
/// have, isn't in it: reading the scene finds it.
[[nodiscard]] DELOS_API Shape scene_shape();

}  // namespace delos
