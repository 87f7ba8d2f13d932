// Where an axis carries numbers, and which.
#pragma once

#include <string>
#include <vector>

namespace delos {

struct Tick {
  double value;       ///< in the axis' units
  std::string label;  ///< as short as tells the ticks apart
};

/// Multiples of 1, 2 or 5 times a power of ten within [low, high], about `wanted` of
/// them.
/// @pre low ≤ high, finite
[[nodiscard]] std::vector<Tick> linear_ticks(double low, double high, int wanted);

/// Values for a logarithmic axis: 1, 2 and 5 times powers of ten, or fewer where they
/// would crowd; linear_ticks() where the range is too short to hold any two of them.
/// Labels carry their unit.
/// @param unit SI unit of low and high
/// @pre 0 < low ≤ high
[[nodiscard]] std::vector<Tick> log_ticks(double low, double high, int wanted,
                                          const std::string& unit);

}  // namespace delos
