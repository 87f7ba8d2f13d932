// What a plugin's parameter may look like in a scene.
#pragma once

#include <string>
#include <vector>

#include "delos/device/parameters.h"
#include "delos/document/shape.h"

namespace delos::session {

/// Whether a scene may leave it out.
[[nodiscard]] bool has_default(const ParamSpec& row);

/// The words of a choice; empty for other kinds.
[[nodiscard]] std::vector<std::string> words_of(const ParamSpec& row);

/// Its shape; that of a choice is any text, whose words words_of() tells.
[[nodiscard]] Shape shape_of(const ParamSpec& row);

}  // namespace delos::session
