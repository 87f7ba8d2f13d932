#include "steady/bias.h"

#include <algorithm>
#include <stdexcept>

#include "delos/scene/definition.h"
#include "riccati/linear.h"
#include "steady/chain_reduction.h"

namespace delos {

std::string bias_problem(const System& system) {
  if (!counts_bias(system)) return "";
  const std::string problem = calibration_problem(system.motion, definition_of(system));
  if (!problem.empty()) return "calibration " + problem;
  if (is_reducible(system)) return "";
  if (system.fusion != Fusion::stacked)
    return "calibration of devices with states of their own isn't known to continuous "
           "fusion; use fusion: stacked, or error: scatter";
  if (!has_one_exposure(system) || system.devices.front().exposure > 0)
    return "calibration of this system isn't known with exposures; leave them out, or "
           "use error: scatter";
  if (system.lag > 0)
    return "calibration of this system isn't known with a lag; leave it out, or use "
           "error: scatter";
  return "";
}

StateMatrix information_of(const SteadyEquation& at) {
  const Measurement& measured = at.steps.front().measurement;
  if (measured.exact.rows() > 0)
    throw std::invalid_argument(
        "a device reads without noise, beside which no calibration error has a weight; "
        "give it noise, or use error: scatter");
  const auto [first, size] = at.block;
  return measured.information.block(first, first, size, size);
}

BiasSolver::BiasSolver(const System& system) : system_(system) {
  if (!is_reducible(system))
    motion_ = discretize(system.motion, system.devices.front().period);
}

void BiasSolver::widen(SteadyRequest& request) const {
  if (motion_) request.posterior = request.whole_state = true;
}

StateMatrix BiasSolver::covariance(const StateMatrix& S, const StateMatrix& D,
                                   const FusedState& state) const {
  if (!motion_) {
    const StateMatrix E = riccati::pseudo_inverse(S, S.diagonal()).inverse;
    return riccati::congruence(E, D);
  }
  const Eigen::Index n = motion_->A.rows(), c = S.rows();
  StateMatrix whole = StateMatrix::Zero(n, n), spread = whole;
  whole.topLeftCorner(c, c) = S;
  spread.topLeftCorner(c, c) = D;
  // What is lost moves by itself: seen along the rest alone.
  const StateMatrix V = riccati::complement(state.unobservable);
  const StateMatrix& P = state.posterior;
  const StateMatrix loop = V.transpose() * (motion_->A - P * (whole * motion_->A)) * V;
  const StateMatrix gain = V.transpose() * P;
  const StateMatrix E =
      riccati::solved(StateMatrix::Identity(loop.rows(), loop.cols()) - loop, gain);
  return riccati::congruence(V * E, spread);
}

void BiasSolver::operator()(const TargetPose& pose, const StateMatrix& S,
                            FusedState& state) {
  apply(system_.error, S, calibration_spread(system_, pose, scratch_), state);
}

void BiasSolver::apply(ErrorPart part, const StateMatrix& S, const StateMatrix& D,
                       FusedState& state) const {
  if (part == ErrorPart::scatter) return;
  const StateMatrix B = covariance(S, D, state);
  for (StateMatrix* P :
       {&state.prior, &state.posterior, &state.worst_prior, &state.best_posterior}) {
    if (P->size() == 0) continue;
    if (part == ErrorPart::bias) P->setZero();
    const Eigen::Index size = std::min(P->rows(), B.rows());
    P->topLeftCorner(size, size) += B.topLeftCorner(size, size);
  }
}

}  // namespace delos
