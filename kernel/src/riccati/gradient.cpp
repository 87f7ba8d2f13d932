// Checks and derivatives of a general solution.
#include <Eigen/LU>
#include <Eigen/QR>
#include <cstdlib>

#include "delos/riccati/riccati.h"
#include "riccati/linear.h"
#include "riccati/update_map.h"

namespace delos {
namespace {

using namespace riccati;

/// X = Σ_t (Fᵀ)ᵗ Y Fᵗ, the solution of X = Fᵀ X F + Y for stable F, by doubling.
StateMatrix stein(StateMatrix F, StateMatrix X) {
  constexpr int kMaxDoublings = 64;
  for (int i = 0; i < kMaxDoublings; ++i) {
    const StateMatrix more = F.transpose() * X * F;
    X = symmetric(X + more);
    if (!(more.norm() > 1e-17 * X.norm())) break;
    F = F * F;
  }
  return X;
}

/// C = I − Π Eᵀ (E Π Eᵀ)⁺ E: the gain of rows without noise, which may depend on each
/// other.
StateMatrix conditioning(const StateMatrix& posterior, const StateMatrix& E) {
  const Eigen::Index n = posterior.rows();
  const StateMatrix EP = E * posterior;
  const Eigen::MatrixXd gain =
      (EP * E.transpose()).eval().completeOrthogonalDecomposition().solve(EP);
  return StateMatrix::Identity(n, n) - gain.transpose() * E;
}

}  // namespace

double riccati_residual(const MotionStep& motion, const Measurement& measurement,
                        const StateMatrix& prior) {
  const StateMatrix next = predict(motion, update(prior, measurement));
  return (next - prior).norm() / prior.norm();
}

StateMatrix riccati_gradient(const MotionStep& motion, const Measurement& measurement,
                             const SteadyState& state, const StateMatrix& Y,
                             bool posterior) {
  if (state.status != RiccatiStatus::converged) std::abort();
  // With M = C (I + PS)⁻¹: dΠ = M dP Mᵀ − Π dS Π and dP = A dΠ Aᵀ, where C conditions
  // on the exact rows. Backwards,
  //     X = Fᵀ X F + Y_P,  F = A M,   ∂J/∂S = −Π (Aᵀ X A [+ Y]) Π,
  // where Y_P = Y for an objective of P, and Mᵀ Y M with the + Y for one of Π.
  const Eigen::Index n = Y.rows();
  const Eigen::PartialPivLU<StateMatrix> W(StateMatrix::Identity(n, n) +
                                           state.prior * measurement.information);
  StateMatrix M = W.inverse();
  if (measurement.rows.rows() > 0)
    M = kept_by_rows(symmetric(M * state.prior), measurement.rows) * M;
  if (measurement.exact.rows() > 0)
    M = conditioning(M * state.prior, measurement.exact) * M;
  const StateMatrix F = motion.A * M;
  const StateMatrix X = stein(F, posterior ? StateMatrix(M.transpose() * Y * M) : Y);
  StateMatrix inner = motion.A.transpose() * X * motion.A;
  if (posterior) inner += Y;
  return symmetric(-state.posterior * inner * state.posterior);
}

}  // namespace delos
