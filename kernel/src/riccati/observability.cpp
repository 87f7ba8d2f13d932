// Undetectable directions by nested subspaces.
//
// With U_j the states after step j of which the future tells nothing,
//
//     U_{j−1} = { x : A_j x ∈ U_j, S_j A_j x = 0, C_j A_j x = 0 }
//
// backwards from U = ℝⁿ until a whole cycle no longer shrinks it. Of U, the part in the
// growing or constant invariant subspace of the cycle's motion is lost; the rest
// decays.
#include "riccati/observability.h"

#include <Eigen/Jacobi>
#include <complex>
#include <limits>

#include "riccati/linear.h"

namespace delos::riccati {
namespace {

/// Sine of the angle below which two directions are the same. Angles carry the rounding
/// of S, at most ~1e-14, amplified by how badly A is conditioned.
constexpr double kSameDirection = 1e-11;
/// How far inside the unit circle an eigenvalue may be computed and still count as on
/// it. Those of triangular A (all integrator chains with biases) are exact.
constexpr double kOnCircle = 1e-10;

/// {x : S x = 0}. An entry of S is a sum that is rounded by ε √(S_ii S_jj): with a unit
/// diagonal, pivots below 16 n ε are that rounding.
StateMatrix kernel(const StateMatrix& S) {
  const Eigen::Index n = S.rows();
  StateVector D(n);
  for (Eigen::Index i = 0; i < n; ++i) D[i] = S(i, i) > 0 ? 1 / std::sqrt(S(i, i)) : 1;
  const StateMatrix unit = D.asDiagonal() * S * D.asDiagonal();
  const StateMatrix null = null_space(unit, 16 * n * kEps);
  return orthonormal(D.asDiagonal() * null);
}

/// U ∩ {x : S x = 0, C x = 0}, for an orthonormal basis U.
StateMatrix unseen(const StateMatrix& U, const Measurement& m) {
  StateMatrix T = kernel(m.information);
  if (m.exact.rows() > 0) {
    const StateMatrix C = m.exact.rowwise().normalized();
    T = T * null_space(C * T, kSameDirection);
  }
  for (Eigen::Index i = 0; i < m.rows.rows() && T.cols() > 0; ++i) {
    const StateMatrix h = m.rows.row(i).normalized();
    T = T * null_space(h * T, kSameDirection);
  }
  if (U.cols() == U.rows()) return T;
  return U * null_space(complement(T).transpose() * U, kSameDirection);
}

/// {x : A x ∈ T}.
StateMatrix preimage(const StateMatrix& A, const StateMatrix& T) {
  return null_space(complement(T).transpose() * A,
                    kSameDirection * A.cwiseAbs().maxCoeff());
}

bool persists(std::complex<double> mu, Stability stability) {
  return (stability == Stability::discrete ? std::abs(mu) : mu.real()) >= 1 - kOnCircle;
}

/// Orthonormal basis of the invariant subspace of the modes that do not die out: the
/// leading Schur vectors once the Schur form is reordered by adjacent swaps. Source:
/// Golub, Van Loan, Matrix Computations, 4th ed., §7.6.2.
StateMatrix persistent_subspace(const StateMatrix& A, Stability stability) {
  using Complex = std::complex<double>;
  auto [T, U] = schur(A);
  const Eigen::Index n = A.rows();
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (!persists(T(i, i), stability)) continue;
    for (Eigen::Index j = i - 1; j >= kept; --j) {
      Eigen::JacobiRotation<Complex> swap;
      swap.makeGivens(T(j, j + 1), T(j + 1, j + 1) - T(j, j));
      T.applyOnTheLeft(j, j + 1, swap.adjoint());
      T.applyOnTheRight(j, j + 1, swap);
      U.applyOnTheRight(j, j + 1, swap);
    }
    ++kept;
  }
  // The subspace is closed under conjugation: the real parts of its projector span it.
  const StateMatrix projector = (U.leftCols(kept) * U.leftCols(kept).adjoint()).real();
  return null_space(StateMatrix::Identity(n, n) - projector, 0.5);
}

}  // namespace

StateMatrix lost_directions(std::span<const CycleStep> cycle, Stability stability) {
  const Eigen::Index n = cycle[0].motion.A.rows();
  const int count = static_cast<int>(cycle.size());
  StateMatrix U = StateMatrix::Identity(n, n);
  for (Eigen::Index before = n + 1; U.cols() < before;) {
    before = U.cols();
    for (int j = count - 1; j >= 0; --j) {
      const StateMatrix T = unseen(U, cycle[j].measurement);
      if (T.cols() == 0) return T;  // what A then carries to zero has decayed
      U = preimage(cycle[j].motion.A, T);
    }
  }
  if (U.cols() == 0) return U;

  StateMatrix motion = StateMatrix::Identity(n, n);
  for (const CycleStep& step : cycle) motion = step.motion.A * motion;
  const StateMatrix E = persistent_subspace(motion, stability);
  if (U.cols() == n) return E;
  return E * null_space(complement(U).transpose() * E, kSameDirection);
}

CycleStep quotient(const CycleStep& step, const StateMatrix& V_before,
                   const StateMatrix& V_after) {
  const auto& [motion, measurement] = step;
  const StateMatrix Vt = V_after.transpose(), AV = motion.A * V_before;
  return {{Vt * AV, congruence(Vt, motion.Q)},
          {congruence(Vt, measurement.information), measurement.exact * V_after,
           in_terms_of(V_after, measurement.rows)}};
}

}  // namespace delos::riccati
