// Scenes whose devices say how well they are known.
#pragma once

#include <string>

#include "session/loaded_scene.h"
#include "support/scene_text.h"

namespace delos::test {

inline System system_of(const std::string& text) {
  return build_system(scene_of(text), plugins());
}

/// Three ranges along the axes, from 4 m.
/// @param keys of each
inline std::string three_ranges(const std::string& keys, const std::string& more = "") {
  std::string text =
      "delos: 1\nmotion: {type: position_velocity, q: [0.4, 0.4, 0.4]}\n" + more +
      "sample: {points: [[0, 0, 0]]}\ndevices:\n";
  int number = 0;
  for (const char* at : {"[4, 0, 0]", "[0, 4, 0]", "[0, 0, 4]"})
    text +=
        "  - {name: r" + std::to_string(++number) +
        ", type: range, rate: 20 Hz, params: {sigma: 3 cm}, at: " + std::string(at) +
        ", " + keys + "}\n";
  return text;
}

/// Two cameras that look across a room at right angles.
inline std::string two_cameras(const std::string& keys, const std::string& more = "") {
  std::string text =
      "delos: 1\nmotion: {type: position_velocity, q: [0.4, 0.4, 0.4]}\n" + more +
      "sample: {points: [[0, 0, 0]]}\ndevices:\n";
  int number = 0;
  for (const char* at : {"[0, 0, -3]", "[-4, 0, 0]"})
    text += "  - {name: c" + std::to_string(++number) +
            ", type: camera, rate: 50 Hz, params: {resolution: [1280, 960], "
            "field_of_view: 60 deg, sigma: 0.3}, aim: [0, 0, 0], at: " +
            std::string(at) + ", " + keys + "}\n";
  return text;
}

}  // namespace delos::test
