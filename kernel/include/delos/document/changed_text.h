// Changes of a text that is no scene yet, or of a scene as it is written.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "delos/api.h"
#include "delos/document/diagnostic.h"
#include "delos/document/override.h"

namespace delos {

/// A YAML text with single values changed, in order, as `--set` changes those of a
/// scene's. What the values mean isn't looked at.
/// @returns nullopt, with errors located as "--set PATH", where a path leads nowhere or
///          a text isn't YAML
[[nodiscard]] DELOS_API std::optional<std::string> changed_text(
    std::string_view text, const std::vector<Override>& changes, Diagnostics& findings);

}  // namespace delos
