// The steady state of a whole system at one pose.
#pragma once

#include "delos/api.h"
#include "delos/model/covariance_kind.h"
#include "delos/riccati/riccati.h"

namespace delos {

/// Whose covariances a FusedState has: what one number stands for where P(t) isn't the
/// same before, after and between all updates.
enum class CovarianceOf {
  every_update,  ///< stacked: before and after any update
  all_times,     ///< continuous: P(t), which stays; prior and posterior are the same
  time_average,  ///< periodic: mean over time by the trapezoid rule, which of chains
                 ///< errs upwards; prior and posterior are the same
  turn_average,  ///< sequential: means over the turns, before and after each
  summed_psi,    ///< artemis: what the sum of Ψ gives; of no Kalman filter
};

/// What P∞ is: "the mean over time, by the trapezoid rule", …
[[nodiscard]] DELOS_API const char* to_string(CovarianceOf of);

/// Steady state of a whole system at one pose.
struct FusedState {
  RiccatiStatus status = RiccatiStatus::converged;
  CovarianceOf of = CovarianceOf::every_update;
  StateMatrix prior;         ///< n×n, or d×d where no more was asked for
  StateMatrix posterior;     ///< likewise
  StateMatrix unobservable;  ///< n×m, orthonormal columns
  /// Of the slowest closed-loop pole, seconds; NaN under artemis fusion.
  double time_constant = 0;
  StateMatrix worst_prior;     ///< periodic and sequential: the largest by pose trace
  StateMatrix best_posterior;  ///< periodic and sequential: the smallest by pose trace

  [[nodiscard]] const StateMatrix& covariance(CovarianceKind kind) const {
    return kind == CovarianceKind::prior ? prior : posterior;
  }
};

}  // namespace delos
