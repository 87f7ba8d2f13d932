// Steady state under continuous measurement: Cayley transform, then doubling.
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstdlib>

#include "delos/riccati/riccati.h"
#include "riccati/balance.h"
#include "riccati/fixed_point.h"
#include "riccati/linear.h"
#include "riccati/observability.h"

namespace delos {
namespace {

using namespace riccati;

/// The information of all that is measured.
StateMatrix summed(const Measurement& rate) {
  StateMatrix S = rate.information;
  for (Eigen::Index i = 0; i < rate.rows.rows(); ++i)
    S += rate.rows.row(i).transpose() * rate.rows.row(i);
  return S;
}

/// Geometric mean of the magnitudes of the closed loop's poles, 1/s. They are the
/// stable half of the eigenvalues of the Hamiltonian [Fᵀ −S; −Q −F], whose determinant
/// is thus their squared product. 1 where a pole is zero.
double mean_pole(const MotionStep& motion, const StateMatrix& S) {
  using Double = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                               2 * kMaxState, 2 * kMaxState>;
  const Eigen::Index n = S.rows();
  Double H(2 * n, 2 * n);
  H << motion.A.transpose(), -S, -motion.Q, -motion.A;
  const Eigen::PartialPivLU<Double> lu(H);
  const double log_mean =
      lu.matrixLU().diagonal().array().abs().log().sum() / (2.0 * n);
  const double mean = std::exp(log_mean);
  return std::isfinite(mean) && mean > 1e-30 ? mean : 1.0;
}

/// One Euler step of 1/γ: what balance() and lost_directions() need of dx/dt = F x.
CycleStep euler(const MotionStep& motion, const Measurement& rate, double gamma) {
  const Eigen::Index n = motion.A.rows();
  return {{StateMatrix::Identity(n, n) + motion.A / gamma, motion.Q / gamma},
          {rate.information / gamma, StateMatrix(0, n), rate.rows / std::sqrt(gamma)}};
}

/// The discrete filter map with the same fixed point, for any γ > 0. With A = Fᵀ,
/// A_γ = A − γI and W = A_γᵀ + Q A_γ⁻¹ S:
///
///     E₀ = I + 2γ W⁻ᵀ,  G₀ = 2γ A_γ⁻¹ S W⁻¹,  H₀ = 2γ W⁻¹ Q A_γ⁻¹
///
/// Source: Chu, Fan, Lin (2005), Linear Algebra Appl. 396, 55–80,
///         doi:10.1016/j.laa.2004.10.010; their E is our Aᵀ. With B = A_γ⁻ᵀ and
/// Y = B Q Bᵀ, W⁻¹ = (I + Y S)⁻¹ B, so that W⁻¹, A_γ⁻¹ S W⁻¹ and W⁻¹ Q A_γ⁻¹ are the
/// map of one update behind a step of B and Y, which takes readings one by one, too.
UpdateMap cayley(const MotionStep& motion, const Measurement& rate, double gamma) {
  const Eigen::Index n = motion.A.rows();
  const StateMatrix I = StateMatrix::Identity(n, n);
  const StateMatrix B = solved(motion.A - gamma * I, I);
  bool regular = true;
  UpdateMap map = one_update({B, congruence(B, motion.Q)}, rate, regular);
  map.A = I + 2 * gamma * map.A;
  map.G *= 2 * gamma;
  map.H *= 2 * gamma;
  return map;
}

}  // namespace

SteadyState solve_continuous(const MotionStep& continuous, const Measurement& rate) {
  const Eigen::Index n = continuous.A.rows();
  const StateMatrix& S = rate.information;
  if (n < 1 || continuous.A.cols() != n || continuous.Q.rows() != n ||
      continuous.Q.cols() != n || S.rows() != n || S.cols() != n ||
      (rate.rows.rows() > 0 && rate.rows.cols() != n))
    std::abort();

  // Balance, and take the lost directions out. The time scale for this takes S as
  // diagonal, which is regular where directions in general position are lost.
  const StateVector diagonal = summed(rate).diagonal();
  const double scale = mean_pole(continuous, diagonal.asDiagonal());
  std::array<CycleStep, 1> step{euler(continuous, rate, scale)};
  const StateVector D = balance(step);
  step[0] = scaled(step[0], D);
  const StateMatrix lost = lost_directions(step, Stability::continuous);
  const StateMatrix V = complement(lost);
  CycleStep left = scaled({continuous, {S, StateMatrix(0, n), rate.rows}}, D);
  if (lost.cols() > 0) left = quotient(left, V, V);

  SteadyState state;
  FixedPoint point{StateMatrix(0, 0), 0, true};
  if (V.cols() > 0) {
    const Measurement& seen = left.measurement;
    point =
        fixed_point(cayley(left.motion, seen, mean_pole(left.motion, summed(seen))));
  }
  const StateMatrix X = D.asDiagonal() * V;
  state.doublings = point.doublings;
  state.status = !point.settled     ? RiccatiStatus::iteration_limit
                 : lost.cols() == 0 ? RiccatiStatus::converged
                                    : RiccatiStatus::unobservable;
  state.unobservable = lost;
  state.prior = congruence(X, point.posterior);
  if (lost.cols() > 0) {
    state.unobservable = orthonormal(D.asDiagonal() * lost);
    state.prior = projected_off(state.prior, state.unobservable);
  }
  state.posterior = state.prior;
  return state;
}

}  // namespace delos
