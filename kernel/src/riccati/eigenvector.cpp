// The papers' own method: eigenvectors of the symplectic matrix Ψ.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "delos/riccati/riccati.h"
#include "riccati/balance.h"
#include "riccati/linear.h"
#include "riccati/observability.h"
#include "riccati/update_map.h"

namespace delos {
namespace {

using namespace riccati;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

/// Ψ = [A + Q A⁻ᵀ S, Q A⁻ᵀ; A⁻ᵀ S, A⁻ᵀ]: takes [B; C] with P = B C⁻¹ to the next
/// update's.
MatrixXd symplectic(const CycleStep& step) {
  const auto& [motion, measurement] = step;
  const Eigen::Index n = motion.A.rows();
  const StateMatrix inverse = solved(motion.A.transpose(), StateMatrix::Identity(n, n));
  const StateMatrix seen = inverse * measurement.information;
  MatrixXd psi(2 * n, 2 * n);
  psi << motion.A + motion.Q * seen, motion.Q * inverse, seen, inverse;
  return psi;
}

/// The n eigenvectors with the largest |eigenvalue|.
MatrixXcd dominant_vectors(const MatrixXd& psi) {
  const Eigen::Index n = psi.rows() / 2;
  const Eigen::ComplexEigenSolver<MatrixXcd> eigen(psi.cast<std::complex<double>>());
  const auto& mu = eigen.eigenvalues();
  std::vector<Eigen::Index> order(2 * n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return std::abs(mu[a]) > std::abs(mu[b]);
  });
  MatrixXcd vectors(2 * n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    vectors.col(i) = eigen.eigenvectors().col(order[i]);
  return vectors;
}

}  // namespace

SteadyState solve_eigenvector(std::span<const CycleStep> steps) {
  if (steps.empty()) std::abort();
  const StateVector D = balance(steps);
  std::vector<CycleStep> left;
  for (const CycleStep& step : steps) left.push_back(scaled(step, D));

  // Everything at once decides what is lost: the sum of Ψ knows no order of devices.
  CycleStep together = left[0];
  for (std::size_t j = 1; j < left.size(); ++j)
    together.measurement.information += left[j].measurement.information;
  const StateMatrix lost = lost_directions({&together, 1}, Stability::discrete);
  const StateMatrix V = complement(lost);
  together = quotient(together, V, V);
  const Eigen::Index n = V.cols();
  StateMatrix P = StateMatrix::Zero(n, n);
  if (n > 0) {
    MatrixXd psi = MatrixXd::Zero(2 * n, 2 * n);
    for (const CycleStep& step : left) psi += symplectic(quotient(step, V, V));
    const MatrixXcd vectors = dominant_vectors(psi);
    // P = B C⁻¹, as Pᵀ = C⁻ᵀ Bᵀ: real, though the vectors come in conjugate pairs.
    const MatrixXcd Bt = vectors.topRows(n).transpose();
    const MatrixXcd Ct = vectors.bottomRows(n).transpose();
    const MatrixXcd Pt = Eigen::PartialPivLU<MatrixXcd>(Ct).solve(Bt);
    P = symmetric(Pt.real());
  }

  SteadyState state;
  const StateMatrix X = D.asDiagonal() * V;
  state.status =
      lost.cols() == 0 ? RiccatiStatus::converged : RiccatiStatus::unobservable;
  // Eigenvectors of nearly defective Ψ, that is of slow filters, may span nothing
  // useful.
  constexpr double kSolved = 1e-4;
  if (n > 0 && left.size() == 1) {
    const MotionStep motion = quotient(left[0], V, V).motion;
    if (!(riccati_residual(motion, together.measurement, P) < kSolved))
      state.status = RiccatiStatus::iteration_limit;
  }
  state.unobservable = lost;
  state.prior = congruence(X, P);
  state.posterior = congruence(X, update(P, together.measurement));
  if (lost.cols() > 0) {
    state.unobservable = orthonormal(D.asDiagonal() * lost);
    state.prior = projected_off(state.prior, state.unobservable);
    state.posterior = projected_off(state.posterior, state.unobservable);
  }
  return state;
}

}  // namespace delos
