// What a scene that is in order may still get wrong, for people and for scripts.
#pragma once

#include "command.h"
#include "json.h"

namespace delos::cli {

/// Devices that see nothing, values of the wrong unit and the like, as warnings.
[[nodiscard]] Diagnostics doubts_of(const std::filesystem::path& file,
                                    const LoadedScene& loaded, PluginRegistry& plugins);

/// The same, and printed to stderr.
[[nodiscard]] Diagnostics print_doubts(const std::filesystem::path& file,
                                       const LoadedScene& loaded,
                                       PluginRegistry& plugins);

/// A list of {severity, file, line, column, message}.
[[nodiscard]] Json diagnostics_json(const Diagnostics& diagnostics);

}  // namespace delos::cli
