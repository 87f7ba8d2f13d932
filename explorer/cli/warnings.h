// What a scene that is in order may still get wrong, for people and for scripts.
#pragma once

#include "command.h"
#include "session/diagnostics_json.h"

namespace delos::cli {

using session::diagnostics_json;

/// Devices that see nothing, values of the wrong unit and the like, as warnings, which
/// are printed to stderr too.
[[nodiscard]] Diagnostics print_doubts(const std::filesystem::path& file,
                                       const LoadedScene& loaded,
                                       PluginRegistry& plugins);

}  // namespace delos::cli
