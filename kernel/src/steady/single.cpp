#include "steady/single.h"

#include "riccati/linear.h"

namespace delos {

SteadyState single_reading(const Measurement& measurement) {
  using namespace riccati;
  constexpr double kSameDirection = 1e-11;
  const StateMatrix& S = measurement.information;
  SteadyState state;
  // x = N y on the exact rows.
  StateMatrix N = StateMatrix::Identity(S.rows(), S.rows());
  if (measurement.exact.rows() > 0)
    N = null_space(measurement.exact.rowwise().normalized(), kSameDirection);
  if (N.cols() == 0) {
    state.posterior = state.prior = StateMatrix::Zero(S.rows(), S.rows());
    state.status = RiccatiStatus::converged;
    state.unobservable = N;
    return state;
  }
  const StateMatrix seen = congruence(N.transpose(), S);
  const auto [inverse, null] = pseudo_inverse(seen, seen.diagonal());
  state.posterior = congruence(N, inverse);
  state.unobservable = N * null;
  state.status = RiccatiStatus::converged;
  if (null.cols() > 0) {
    state.status = RiccatiStatus::unobservable;
    state.unobservable = orthonormal(state.unobservable);
    state.posterior = projected_off(state.posterior, state.unobservable);
  }
  state.prior = state.posterior;
  return state;
}

StateMatrix single_reading_gradient(const SteadyState& state, const StateMatrix& Y) {
  return -riccati::congruence(state.posterior, Y);
}

}  // namespace delos
