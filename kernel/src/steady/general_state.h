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
