// Checks and derivatives of a general solution.
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
    const StateMatrix more = congruence(F.transpose(), X);
    X = symmetric(X + more);
    if (!(more.norm() > 1e-17 * X.norm())) break;
    F = F * F;
  }
  return X;
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
  // With M = C (I + PS)⁻¹: dΠ = M dP Mᵀ − Π dS Π and dP = A dΠ Aᵀ, where C = I − L E
  // conditions on the exact rows. Backwards,
  //     X = Fᵀ X F + Y_P,  F = A M,   ∂J/∂S = −Π (Aᵀ X A [+ Y]) Π,
  // where Y_P = Y for an objective of P, and Mᵀ Y M with the + Y for one of Π.
  const Eigen::Index n = Y.rows();
  const StateMatrix I = StateMatrix::Identity(n, n);
  StateMatrix M = solved(I + state.prior * measurement.information, I);
  if (measurement.rows.rows() > 0)
    M = kept_by_rows(symmetric(M * state.prior), measurement.rows) * M;
  if (measurement.exact.rows() > 0) {
    const StateMatrix& E = measurement.exact;
    const StateMatrix seen = E * M;
    M -= exact_gain(M * state.prior, E).L * seen;
  }
  const StateMatrix F = motion.A * M;
  const StateMatrix X = stein(F, posterior ? congruence(M.transpose(), Y) : Y);
  StateMatrix inner = congruence(motion.A.transpose(), X);
  if (posterior) inner += Y;
  return -congruence(state.posterior, inner);
}

}  // namespace delos
