// Single readings of more than the pose.
#pragma once

#include "delos/riccati/riccati.h"

namespace delos {

/// The covariance of one update's readings alone, with nothing known before: S⁻¹ along
/// what they see, and 0 along exact rows. A singular S loses the directions of its null
/// space. Prior and posterior are the same.
[[nodiscard]] SteadyState single_reading(const Measurement& measurement);

/// ∂J/∂S = −Π Y Π of an objective with ∂J/∂Π = Y.
/// @param Y n×n, symmetric
[[nodiscard]] StateMatrix single_reading_gradient(const SteadyState& state,
                                                  const StateMatrix& Y);

}  // namespace delos
