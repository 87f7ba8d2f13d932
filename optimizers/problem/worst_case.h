// The greatest of a few objectives, softened.
#pragma once

#include <span>

namespace delos {

/// How sharp a greatest value is where nothing is soft any more.
inline constexpr double kSharpest = 600;

/// A smooth bound of the greatest of some numbers F:
///
///     (M/s) log Σ exp(s F/M),   M² the mean of F²
///
/// It is above the greatest by (M/s) log n at most. 0 where all are 0.
/// @param values one or more
/// @param sharpness s > 0
/// @param[out] slopes ∂/∂F, one a value, or null
[[nodiscard]] double soft_greatest(std::span<const double> values, double sharpness,
                                   double* slopes);

}  // namespace delos
