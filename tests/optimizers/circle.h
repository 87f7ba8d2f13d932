// Speakers on a circle around one target.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "optimizers/scenes.h"

namespace delos::test {

/// Noise of a speaker in the circle's plane, one metre away, square metres.
inline constexpr double kSpeakerNoise = 0.01;
/// Spectral density of the target's random walk, m²/s, and updates a second.
inline constexpr double kWalk = 0.4, kUpdates = 50;

/// A target at the origin that walks at random; speakers d0, d1, … on a rail around it,
/// a polygon of 180 sides and radius 1 m; another above, which pins z.
/// @param first_fixed d0 stays where it is
inline std::string circle(const std::vector<double>& degrees, bool first_fixed) {
  std::string text =
      "delos: 1\nname: Circle\nmotion: {type: position, q: [0.4, 0.4, 0.4]}\n"
      "sample: {points: [[0, 0, 0]]}\nsurfaces:\n  around: {rail: [";
  constexpr int kSides = 180;
  for (int i = 0; i <= kSides; ++i) {
    const double angle = 2 * std::numbers::pi * (i % kSides) / kSides;
    text += (i > 0 ? ", [" : "[") + std::to_string(std::cos(angle)) + ", " +
            std::to_string(std::sin(angle)) + ", 0]";
  }
  text += "]}\ndevices:\n";
  std::string variables = "variables:\n";
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const std::string name = "d" + std::to_string(i);
    text += "  - {name: " + name + ", rate: 50, type: acoustic_range, on: around, " +
            "coordinates: " + std::to_string(degrees[i] / 360) +
            ", params: {r: 0.01}}\n";
    if (i > 0 || !first_fixed)
      variables += "  - {path: devices." + name + ".coordinates.0}\n";
  }
  return text +
         "  - {name: above, rate: 50, type: acoustic_range, at: [0, 0, 1], params: {r: "
         "1.0e-6}}\n" +
         variables + "objective: {minimize: mean, of: eigmax, guess: 100}\n";
}

/// eigmax with m speakers evenly spread: S = m/(2r) I in the plane, and each axis by
///
///   P = (P⁻¹ + m/2r)⁻¹ + qT   ⇒   P² − qT P − qT 2r/m = 0
inline double even_eigmax(int m) {
  const double walk = kWalk / kUpdates, noise = 2 * kSpeakerNoise / m;
  return std::sqrt((walk + std::sqrt(walk * walk + 4 * walk * noise)) / 2);
}

}  // namespace delos::test
