// Floats on the safe side of doubles.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace delos {

/// Coordinates beyond this count as infinite, metres.
inline constexpr double kFarthest = 1e30;
/// Floats below and above are at least this far away, metres.
inline constexpr double kNearest = 2e-30;

/// A float that is less than x, by more than x was rounded in doubles.
inline float float_below(double x) {
  x -= 1.2e-7 * std::abs(x) + kNearest;  // a float's half step is 6e-8 at most
  if (x < -kFarthest) return -std::numeric_limits<float>::max();
  return static_cast<float>(std::min(x, kFarthest));
}
inline float float_above(double x) { return -float_below(-x); }

}  // namespace delos
