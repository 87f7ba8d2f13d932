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
  // With M of kept(): dΠ = M dP Mᵀ − Π dS Π and dP = A dΠ Aᵀ. Backwards,
  //     X = Fᵀ X F + Y_P,  F = A M,   ∂J/∂S = −Π (Aᵀ X A [+ Y]) Π,
  // where Y_P = Y for an objective of P, and Mᵀ Y M with the + Y for one of Π.
  const StateMatrix M = kept(state.prior, measurement);
  const StateMatrix F = motion.A * M;
  const StateMatrix X = stein(F, posterior ? congruence(M.transpose(), Y) : Y);
  StateMatrix inner = congruence(motion.A.transpose(), X);
  if (posterior) inner += Y;
  return -congruence(state.posterior, inner);
}

}  // namespace delos
