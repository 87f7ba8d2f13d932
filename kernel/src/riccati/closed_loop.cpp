// How fast the steady filter forgets: eigenvalues of its closed loop.
#include <Eigen/Eigenvalues>

#include "delos/riccati/riccati.h"
#include "riccati/linear.h"

namespace delos {
namespace {

using riccati::orthonormal;
using riccati::pseudo_inverse;

/// I − K H = Π P⁻¹, off the lost directions. Where P is singular nothing is corrected:
/// the directions without variance are kept as they are.
StateMatrix correction(const SteadyState& state) {
  const auto [inverse, null] = pseudo_inverse(state.prior, state.prior.diagonal());
  StateMatrix keep = state.posterior * inverse;
  if (null.cols() > 0) {
    const StateMatrix basis = orthonormal(null);
    keep += basis * basis.transpose();
  }
  const Eigen::Index n = keep.rows();
  const StateMatrix observed = StateMatrix::Identity(n, n) -
                               state.unobservable * state.unobservable.transpose();
  return observed * keep * observed;
}

Eigen::VectorXcd poles(const StateMatrix& loop) {
  return Eigen::EigenSolver<StateMatrix>(loop, false).eigenvalues();
}

}  // namespace

double closed_loop_radius(std::span<const CycleStep> cycle,
                          std::span<const SteadyState> states) {
  const Eigen::Index n = cycle.front().motion.A.rows();
  StateMatrix loop = StateMatrix::Identity(n, n);
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    loop = (correction(states[i]) * (cycle[i].motion.A * loop)).eval();
  }
  return poles(loop).cwiseAbs().maxCoeff();
}

double continuous_closed_loop_rate(const MotionStep& continuous,
                                   const StateMatrix& information_rate,
                                   const StateMatrix& P) {
  return poles(continuous.A - P * information_rate).real().maxCoeff();
}

}  // namespace delos
