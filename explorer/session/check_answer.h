// Whether a scene is in order, and what it is in numbers.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "delos/document/override.h"
#include "delos/field/existence.h"
#include "delos/steady/steady_solver.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// A scene in order, in numbers.
struct SceneFacts {
  std::size_t devices = 0, states = 0;
  std::size_t samples = 0;  ///< 0: adaptive, so that they aren't known yet
  std::string fusion, solver;
  std::vector<std::string> presets;  ///< preset_sources()
  Existence existence;
};

/// What came of checking one file.
struct CheckedScene {
  std::filesystem::path file;
  Diagnostics diagnostics;
  std::optional<SceneFacts> facts;  ///< empty where a diagnostic is an error
};

/// Load and build it; what may be wrong with one in order is a warning.
/// @throws as load()
[[nodiscard]] CheckedScene check_scene(const std::filesystem::path& file,
                                       const std::vector<Override>& overrides,
                                       PluginRegistry& plugins, Solver solver);

/// Devices that see nothing, values of the wrong unit and the like, as warnings.
[[nodiscard]] Diagnostics doubts_of(const std::filesystem::path& file,
                                    const LoadedScene& loaded, PluginRegistry& plugins);

/// One scene of `check --json`.
[[nodiscard]] Json check_json(const CheckedScene& checked);

}  // namespace delos::session
