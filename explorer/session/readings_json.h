// How good readings are, as JSON (`power`, `noise` and `shutter` with --json).
#pragma once

#include <optional>
#include <vector>

#include "readings/amplifier_noise.h"
#include "readings/coded_window.h"
#include "readings/power.h"
#include "session/json.h"

namespace delos::session {

/// What is asked of a test, and the one number of the three that wasn't given.
struct PowerAnswer {
  readings::PowerTest test;
  double effect = 0, count = 0, power = 0;
};

/// @pre two of effect, count and power are given
[[nodiscard]] PowerAnswer answer_power(const readings::PowerTest& test,
                                       std::optional<double> effect,
                                       std::optional<double> count,
                                       std::optional<double> power);
[[nodiscard]] Json power_json(const PowerAnswer& answer);

/// The noise of an amplifier by its windows.
struct NoiseAnswer {
  readings::Amplifier amplifier;
  double current = 0, x = 0, readings = 1;
  std::vector<double> windows;                 ///< seconds
  std::vector<readings::PositionNoise> noise;  ///< of each
};

[[nodiscard]] NoiseAnswer answer_noise(const readings::Amplifier& amplifier,
                                       double current, double x, double readings,
                                       const std::vector<double>& windows);
[[nodiscard]] Json noise_json(const NoiseAnswer& answer);

[[nodiscard]] Json shutter_json(const readings::CodedWindow& window);

}  // namespace delos::session
