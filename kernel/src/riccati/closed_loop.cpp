// How fast the steady filter forgets: eigenvalues of its closed loop.
#include "delos/riccati/riccati.h"
#include "riccati/linear.h"
#include "riccati/update_map.h"

namespace delos {
namespace {

using riccati::congruence;
using riccati::eigenvalues;
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
    const StateMatrix rest = I - M;
    M += rest * congruence(N, StateMatrix::Identity(N.cols(), N.cols()));
  }
  const StateMatrix observed = I - state.unobservable * state.unobservable.transpose();
  M = M * observed;
  return observed * M;
}

}  // namespace

double closed_loop_radius(std::span<const CycleStep> cycle,
                          std::span<const SteadyState> states) {
  const Eigen::Index n = cycle.front().motion.A.rows();
  StateMatrix loop = StateMatrix::Identity(n, n);
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    loop = cycle[i].motion.A * loop;
    loop = correction(states[i]) * loop;
  }
  return eigenvalues(loop).cwiseAbs().maxCoeff();
}

double closed_loop_radius_by_gain(std::span<const CycleStep> cycle,
                                  std::span<const SteadyState> states) {
  const Eigen::Index n = cycle.front().motion.A.rows();
  StateMatrix loop = StateMatrix::Identity(n, n);
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    loop = cycle[i].motion.A * loop;
    loop = riccati::kept(states[i].prior, cycle[i].measurement) * loop;
    const StateMatrix& lost = states[i].unobservable;
    loop -= lost * (lost.transpose() * loop).eval();
  }
  return eigenvalues(loop).cwiseAbs().maxCoeff();
}

double continuous_closed_loop_rate(const MotionStep& continuous,
                                   const Measurement& rate, const StateMatrix& P) {
  StateMatrix loop = continuous.A - P * rate.information;
  for (Eigen::Index i = 0; i < rate.rows.rows(); ++i) {
    const StateVector h = rate.rows.row(i).transpose(), Ph = P * h;
    loop -= Ph * h.transpose();
  }
  return eigenvalues(loop).real().maxCoeff();
}

}  // namespace delos
