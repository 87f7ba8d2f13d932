// A scene ready to be evaluated.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "delos/model/metric.h"
#include "delos/plugin/registry.h"
#include "delos/rig/system.h"
#include "delos/scene/io.h"

namespace delos::session {

struct LoadedScene {
  Scene scene;
  System system;
  Metric metric;
};

/// Where a scene comes from.
struct SceneSource {
  std::filesystem::path file;  ///< names it in messages; relative paths start there
  std::optional<std::string> text = {};  ///< instead of the file's
  std::vector<Override> changes = {};    ///< made in order before it is checked
};

/// Load, change and build; findings are appended, warnings too. A scene without a name
/// gets its file's.
/// @param previous as build_system()
/// @returns nullopt where a finding is an error
/// @throws as build_system()
[[nodiscard]] std::optional<LoadedScene> load(const SceneSource& source,
                                              PluginRegistry& plugins,
                                              Diagnostics& diagnostics,
                                              const MeshProgress& progress = {},
                                              const System* previous = nullptr);

/// The same of a file.
[[nodiscard]] std::optional<LoadedScene> load(const std::filesystem::path& file,
                                              const std::vector<Override>& overrides,
                                              PluginRegistry& plugins,
                                              Diagnostics& diagnostics,
                                              const MeshProgress& progress = {},
                                              const System* previous = nullptr);

/// The same, without warnings.
/// @throws Refusal with all findings where one is an error
/// @throws as build_system()
[[nodiscard]] LoadedScene load(const SceneSource& source, PluginRegistry& plugins);

/// A scene that is in order, such as a search's, made ready.
/// @throws as build_system()
[[nodiscard]] LoadedScene loaded_from(Scene scene, PluginRegistry& plugins,
                                      const System* previous = nullptr);

}  // namespace delos::session
