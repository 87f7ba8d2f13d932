// Scenes of a camera whose image has as many pixels a metre as are asked for.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "session/loaded_scene.h"
#include "support/scene_text.h"

namespace delos::test {

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

/// A scene ready to be asked about. @param metric of its states
inline session::LoadedScene loaded(const Scene& scene) {
  return {scene, build_system(scene, plugins()),
          std::get<Metric>(parse_metric(scene.metric, scene.motion.layout))};
}

}  // namespace delos::test
