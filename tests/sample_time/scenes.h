// Scenes of a camera whose image has as many pixels a metre as are asked for.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "delos/scene/io.h"
#include "session/loaded_scene.h"

namespace delos::test {

inline PluginRegistry& plugins() {
  static PluginRegistry registry({DELOS_PLUGINS});
  return registry;
}

/// Two cameras a metre away at right angles, of whose rows |h| is 1 px/m.
/// @param keys of each device, such as "rate: 50 Hz"
inline std::string two_cameras(const std::string& keys, const std::string& more = "") {
  const std::string device =
      "type: pinhole_camera, params: {focal: 1 mm, pitch: 1 mm, resolution: [2, 2], "
      "sigma: 3.16227766016838e-4}, " +
      keys;
  return "delos: 1\n"
         "motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}\n" +
         more +
         "sample: {points: [[0, 0, 0]]}\n"
         "devices:\n"
         "  - {name: a, at: [0, 0, -1], " +
         device +
         "}\n"
         "  - {name: b, at: [-1, 0, 0], aim: [0, 0, 0], " +
         device + "}\n";
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

/// A scene ready to be asked about. @param metric of its states
inline session::LoadedScene loaded(const Scene& scene) {
  return {scene, build_system(scene, plugins()),
          std::get<Metric>(parse_metric(scene.metric, scene.motion.layout))};
}

}  // namespace delos::test
