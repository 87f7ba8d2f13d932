// Scenes of text, with the plugins that were built, and what is said of them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "delos/scene/io.h"

namespace delos::test {

inline PluginRegistry& plugins() {
  static PluginRegistry registry({DELOS_PLUGINS});
  return registry;
}

/// What is said of a scene, as it is shown.
inline std::vector<std::string> findings_of(const std::string& text) {
  Diagnostics diagnostics;
  (void)parse_scene(text, "s.yaml", {}, plugins(), diagnostics);
  std::vector<std::string> out;
  for (const Diagnostic& d : diagnostics) out.push_back(to_string(d));
  return out;
}

inline Scene scene_of(const std::string& text) {
  Diagnostics diagnostics;
  auto scene = parse_scene(text, "s.yaml", {}, plugins(), diagnostics);
  for (const Diagnostic& d : diagnostics) ADD_FAILURE() << to_string(d);
  return scene.value_or(Scene{});
}

}  // namespace delos::test
