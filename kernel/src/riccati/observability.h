// Which directions of the state a cycle of updates leaves without a finite variance.
#pragma once

#include <span>

#include "delos/riccati/riccati.h"

namespace delos::riccati {

/// Which modes of x⁺ = A x do not die out by themselves.
enum class Stability {
  discrete,    ///< |μ| ≥ 1
  continuous,  ///< A is I + F/γ for dx/dt = F x: Re μ ≥ 1
};

/// Orthonormal basis, n×m, of the lost directions at the end of the cycle's last step:
/// those that no measurement ever sees, of modes that do not decay. m = 0: detectable.
/// @param cycle balanced (balance.h), so that angles between directions mean something
StateMatrix lost_directions(std::span<const CycleStep> cycle, Stability stability);

/// The step for what is left of the state: y = Vᵀ x, with V orthogonal to what was lost
/// before and after the step.
CycleStep quotient(const CycleStep& step, const StateMatrix& V_before,
                   const StateMatrix& V_after);

}  // namespace delos::riccati
