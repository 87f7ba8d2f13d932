// Checks and derivatives of a general solution.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
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

}  // namespace

double riccati_residual(const MotionStep& motion, const Measurement& measurement,
                        const StateMatrix& prior) {
  const StateMatrix next = predict(motion, update(prior, measurement));
  return (next - prior).norm() / prior.norm();
}

double closed_loop_radius(const MotionStep& motion, const SteadyState& state) {
  // A − KH = A M with M = I − K′H = Π P⁻¹. Where P is singular, its range is invariant
  // under A, and M changes nothing modulo that range: M = 1 on the null space has the
  // same eigenvalues. Lost directions are no part of the filter.
  const Eigen::Index n = motion.A.rows();
  const auto [inverse, null] = pseudo_inverse(state.prior, state.prior.diagonal());
  StateMatrix M = state.posterior * inverse;
  if (null.cols() > 0) {
    const StateMatrix N = orthonormal(null);
    M += (StateMatrix::Identity(n, n) - M) * N * N.transpose();
  }
  const StateMatrix V = complement(state.unobservable);
  if (V.cols() == 0) return 0;
  return Eigen::EigenSolver<StateMatrix>(V.transpose() * motion.A * M * V, false)
      .eigenvalues()
      .cwiseAbs()
      .maxCoeff();
}

StateMatrix riccati_gradient(const MotionStep& motion, const Measurement& measurement,
                             const SteadyState& state, const StateMatrix& Y,
                             bool posterior) {
  if (state.status != RiccatiStatus::converged || measurement.exact.rows() > 0)
    std::abort();
  // With M = (I + PS)⁻¹: dΠ = M dP Mᵀ − Π dS Π and dP = A dΠ Aᵀ. Backwards,
  //     X = Fᵀ X F + Y_P,  F = A M,   ∂J/∂S = −Π (Aᵀ X A [+ Y]) Π,
  // where Y_P = Y for an objective of P, and Mᵀ Y M with the + Y for one of Π.
  const Eigen::Index n = Y.rows();
  const Eigen::PartialPivLU<StateMatrix> W(StateMatrix::Identity(n, n) +
                                           state.prior * measurement.information);
  const StateMatrix M = W.inverse();
  const StateMatrix F = motion.A * M;
  const StateMatrix X = stein(F, posterior ? StateMatrix(M.transpose() * Y * M) : Y);
  StateMatrix inner = motion.A.transpose() * X * motion.A;
  if (posterior) inner += Y;
  return symmetric(-state.posterior * inner * state.posterior);
}

}  // namespace delos
