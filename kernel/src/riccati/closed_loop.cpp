// How fast the steady filter forgets: eigenvalues of its closed loop.
#include <Eigen/Eigenvalues>

#include "delos/riccati/riccati.h"
#include "riccati/linear.h"

namespace delos {
namespace {

using riccati::orthonormal;
using riccati::pseudo_inverse;

/// I − K H = Π P⁻¹, off the lost directions. Where P is singular, its range is
/// invariant under A and nothing changes modulo that range: 1 on the null space has the
/// same eigenvalues.
StateMatrix correction(const SteadyState& state) {
  const Eigen::Index n = state.prior.rows();
  const StateMatrix I = StateMatrix::Identity(n, n);
  const auto [inverse, null] = pseudo_inverse(state.prior, state.prior.diagonal());
  StateMatrix M = state.posterior * inverse;
  if (null.cols() > 0) {
    const StateMatrix N = orthonormal(null);
    M += (I - M) * N * N.transpose();
  }
  const StateMatrix observed = I - state.unobservable * state.unobservable.transpose();
  return observed * M * observed;
}

Eigen::EigenSolver<StateMatrix>::EigenvalueType poles(const StateMatrix& loop) {
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
