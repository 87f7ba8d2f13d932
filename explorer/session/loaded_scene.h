// A scene ready to be evaluated.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "delos/model/metric.h"
#include "delos/rig/system.h"
#include "delos/scene/io.h"

namespace delos::session {

struct LoadedScene {
  Scene scene;
  System system;
  Metric metric;
};

/// Load, override and build; findings are appended, warnings too. A scene without a
/// name gets its file's.
/// @param previous as build_system()
/// @returns nullopt where a finding is an error
/// @throws as build_system()
[[nodiscard]] std::optional<LoadedScene> load(const std::filesystem::path& file,
                                              const std::vector<Override>& overrides,
                                              PluginRegistry& plugins,
                                              Diagnostics& diagnostics,
                                              const MeshProgress& progress = {},
                                              const System* previous = nullptr);

/// The same of a scene's text. @param file what relative paths start from
[[nodiscard]] std::optional<LoadedScene> load_text(
    const std::string& text, const std::filesystem::path& file,
    const std::vector<Override>& overrides, PluginRegistry& plugins,
    Diagnostics& diagnostics, const System* previous = nullptr);

}  // namespace delos::session
