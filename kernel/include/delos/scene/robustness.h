// What a design should withstand: failures, and devices that are a little off.
#pragma once

#include <string>
#include <vector>

namespace delos {

/// How the objectives of several draws become one.
enum class DrawRule {
  mean,   ///< what is to be expected
  worst,  ///< the worst of them
};

/// What an objective withstands. Of each draw it takes the worst of all devices present
/// and of each failure; of the draws, their mean or the worst.
struct Robustness {
  std::vector<std::string> failures;  ///< devices of which one may fail; empty: none
  /// Standard deviations of how a device is mounted: of its place along each of the
  /// world's axes, metres, and of a turn about each of its own, radians.
  double place = 0, angle = 0;
  /// Standard deviation of the logarithm of a device's noise.
  double noise = 0;
  int draws = 16;  ///< of mounting and noise, ≥ 1
  int seed = 1;    ///< ≥ 0
  DrawRule combine = DrawRule::mean;

  /// Whether anything is drawn.
  [[nodiscard]] bool is_drawn() const { return place > 0 || angle > 0 || noise > 0; }
  friend bool operator==(const Robustness&, const Robustness&) = default;
};

}  // namespace delos
