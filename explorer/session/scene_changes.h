// What makes one scene out of another, as changes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "delos/document/override.h"
#include "delos/plugin/registry.h"
#include "delos/scene/scene.h"

namespace delos::session {

/// The changes of top-level keys, as `--set` would make them, that turn a scene into
/// another whose relative paths start in the same folder.
[[nodiscard]] std::vector<Override> changes_between(const Scene& from, const Scene& to);

/// The same of scenes as write_scene() writes them.
[[nodiscard]] std::vector<Override> changes_between_texts(const std::string& from,
                                                          const std::string& to);

/// Values of variables, SI.
struct VariableValues {
  std::vector<std::string> paths;
  std::vector<double> values;  ///< as many
};

/// The values that the variables of a scene have.
[[nodiscard]] VariableValues values_of(Scene scene, PluginRegistry& plugins);

/// The scene with such values, and what follows them.
/// @throws std::invalid_argument it has no such variable any more
[[nodiscard]] Scene with_values(Scene scene, const VariableValues& values,
                                PluginRegistry& plugins);

}  // namespace delos::session
