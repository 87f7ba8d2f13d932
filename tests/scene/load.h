// Loads scene texts with the plugins of this folder.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "delos/scene/io.h"
#include "support/folder.h"

namespace delos::test {

/// A scene without findings; other tests change a part of it.
inline const std::string kGood = R"(delos: 1
name: Good
motion:
  type: position_velocity
  state: position
  q: [0.4, 0.4, 0.1]
sample:
  volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}
groups:
  rig1: {at: [0, 0, 2]}
devices:
  - name: s1
    type: probe
    rate: 50 Hz
    at: [0, 0, 1]
    params: {r: 5 mm}
  - {name: s2, type: probe, rate: 50, at: [1, 0, 1], aim: [0, 0, 0], params: {r: 0.005}}
)";

/// kGood with one part exchanged.
inline std::string good_with(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("kGood has no " + from);
  return text.replace(at, from.size(), to);
}

inline PluginRegistry& plugins() {
  static PluginRegistry registry({DELOS_TEST_PLUGINS});
  return registry;
}

struct Loaded {
  std::optional<Scene> scene;
  std::vector<std::string> findings;  ///< as they are shown
};

inline Loaded load(const std::string& text,
                   const std::vector<Override>& overrides = {}) {
  Diagnostics diagnostics;
  Loaded loaded;
  loaded.scene = parse_scene(text, "scene.yaml", overrides, plugins(), diagnostics);
  for (const Diagnostic& d : diagnostics) loaded.findings.push_back(to_string(d));
  return loaded;
}

/// The scene; its findings are failures.
inline Scene accepted(const Loaded& loaded) {
  for (const std::string& finding : loaded.findings) ADD_FAILURE() << finding;
  return loaded.scene.value_or(Scene{});
}

inline Scene accepted(const std::string& text,
                      const std::vector<Override>& overrides = {}) {
  return accepted(load(text, overrides));
}

/// kGood with more lines.
inline Scene scene_with(const std::string& lines) { return accepted(kGood + lines); }

}  // namespace delos::test
