// What the general solvers of all fusions share.
#pragma once

#include <cmath>
#include <numeric>
#include <vector>

#include "delos/model/infinity.h"
#include "delos/steady/equation.h"
#include "delos/steady/fused_state.h"
#include "riccati/linear.h"

namespace delos {

/// What a state of the motion's n states, and of means behind them, says of those n.
/// A lost mean is one of a lost state.
inline void restrict_to(Eigen::Index n, SteadyState& state) {
  if (state.prior.rows() == n) return;
  const StateMatrix lost = riccati::orthonormal(state.unobservable.topRows(n));
  state.prior = riccati::projected_off(state.prior.topLeftCorner(n, n), lost);
  state.posterior = riccati::projected_off(state.posterior.topLeftCorner(n, n), lost);
  state.unobservable = lost;
}

/// What is left of the digits of P∞ to a rounding of S: an entry S_ij is rounded by
/// ε √(S_ii S_jj), which P weighs. At 1e5 some 1e-11 of P are lost.
inline constexpr double kMostWeight = 1e5;

/// max S_ii P_ii
inline double weight_of_information(const StateMatrix& S, const StateMatrix& P) {
  return (S.diagonal().array() * P.diagonal().array()).maxCoeff();
}

/// Whether a solution by sums of information may have lost digits that single readings
/// have.
inline bool may_lack_digits(const SteadyEquation& at) {
  for (std::size_t s = 0; s < at.steps.size(); ++s) {
    const SteadyState& state = at.states[s];
    if (state.status != RiccatiStatus::converged ||
        !(weight_of_information(at.steps[s].measurement.information, state.prior) <
          kMostWeight))
      return true;
  }
  return false;
}

/// One instant's state as that of the system.
inline void set_state(const SteadyState& state, FusedState& out) {
  out.status = state.status;
  out.prior = state.prior;
  out.posterior = state.posterior;
  out.unobservable = state.unobservable;
}

/// −T/ln ρ of a closed loop that shrinks by ρ in T seconds.
inline double time_constant_of_radius(double radius, double period) {
  if (radius >= 1) return kInfinity;
  return radius > 0 ? -period / std::log(radius) : 0;
}

/// The closed loop of an equation whose motion has n states, solved.
inline double radius_of(const SteadyEquation& at, Eigen::Index n) {
  const bool with_means = at.steps.front().motion.A.rows() > n;
  return with_means ? closed_loop_radius_by_gain(at.steps, at.states)
                    : closed_loop_radius(at.steps, at.states);
}

/// 0 … count − 1: devices that all report at once.
inline std::vector<int> all_devices(std::size_t count) {
  std::vector<int> devices(count);
  std::iota(devices.begin(), devices.end(), 0);
  return devices;
}

}  // namespace delos
