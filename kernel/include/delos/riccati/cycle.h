// What a whole cycle of updates amounts to.
#pragma once

#include <span>

#include "delos/api.h"
#include "delos/riccati/riccati.h"

namespace delos {

/// How P(t) between two updates is averaged.
enum class AverageRule {
  /// The integral: P(t) of a chain is a polynomial of degree 2k − 1 ≤ 5, which three
  /// Gauss–Legendre nodes integrate without error.
  exact,
  /// As if P(t) ran straight from each posterior to the next prior. P(t) is convex for
  /// chains, so this is an upper bound; the table of docs/theory.md §4 was made with
  /// it.
  trapezoid,
};

/// Mean over time of the covariance P(t) between the updates of a cycle:
///
///     (1/T) Σ_j ∫₀^{dt_j} A(t) Π_{j−1} A(t)ᵀ + Q(t) dt,  T = Σ dt_j
///
/// Models other than chains are always averaged by the trapezoid: a custom one has no
/// inside, and that of a continuous one is no polynomial.
/// @param durations dt_j, seconds: the time that leads to step j, > 0
/// @param states of solve_cycle(): Π_{j−1} is the posterior of the step before, of the
/// last
///        one for j = 0. Lost directions are projected off, as in SteadyState.
/// @pre durations.size() == states.size() ≥ 1; aborts if not.
[[nodiscard]] DELOS_API StateMatrix time_average(const MotionModel& motion,
                                                 std::span<const double> durations,
                                                 std::span<const SteadyState> states,
                                                 AverageRule rule = AverageRule::exact);

}  // namespace delos
