// Eigenvalues of a small symmetric matrix by Jacobi rotations.
//
// Chosen over tridiagonal QR for its accuracy: on a positive definite matrix the
// stopping rule |m_pq| ≤ ε √(m_pp m_qq) finds small eigenvalues to the relative
// accuracy that the matrix itself holds, however widely its diagonal is graded. For d =
// 3 it is also faster. Source: Demmel, Veselić (1992), "Jacobi's method is more
// accurate than QR",
//         SIAM J. Matrix Anal. Appl. 13(4), 1204–1245, doi:10.1137/0613074.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <utility>

namespace delos::riccati {

/// M = U diag(λ) Uᵀ, λ ascending.
template <int kSize>
struct JacobiResult {
  Eigen::Matrix<double, kSize, 1> lambda;
  Eigen::Matrix<double, kSize, kSize> U;
};

/// Sort eigenvalues and their vectors, smallest first.
template <int kSize>
void sort_ascending(JacobiResult<kSize>& r) {
  for (int i = 1; i < kSize; ++i) {
    for (int j = i; j > 0 && r.lambda[j] < r.lambda[j - 1]; --j) {
      std::swap(r.lambda[j], r.lambda[j - 1]);
      r.U.col(j).swap(r.U.col(j - 1));
    }
  }
}

/// @param M symmetric; the upper triangle is read. Entries below 1e150 in magnitude,
/// for
///          their squares are formed.
template <int kSize>
JacobiResult<kSize> jacobi_eigen(Eigen::Matrix<double, kSize, kSize> M) {
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  constexpr int kMaxSweeps = 30;  // five is the most ever seen; 30 stops NaNs
  JacobiResult<kSize> r;
  r.U.setIdentity();
  const double scale = M.diagonal().cwiseAbs().maxCoeff();
  const double floor = kEps * kEps * scale;  // far below any eigenvalue that is used

  for (int sweep = 0, rotations = 1; sweep < kMaxSweeps && rotations > 0; ++sweep) {
    rotations = 0;
    for (int p = 0; p + 1 < kSize; ++p) {
      for (int q = p + 1; q < kSize; ++q) {
        const double x = M(p, q), mp = M(p, p), mq = M(q, q);
        if (x * x <= kEps * kEps * std::abs(mp * mq) || std::abs(x) <= floor) continue;
        ++rotations;

        // tan of the smaller angle that zeroes m_pq.
        const double h = mq - mp;
        const double t = 2 * x / (h + std::copysign(std::sqrt(h * h + 4 * x * x), h));
        const double c = 1 / std::sqrt(1 + t * t), s = t * c;
        M(p, p) = mp - t * x;
        M(q, q) = mq + t * x;
        M(p, q) = 0;
        const auto rotate = [c, s](double& a, double& b) {
          const double old = a;
          a = c * old - s * b;
          b = s * old + c * b;
        };
        for (int i = 0; i < p; ++i) rotate(M(i, p), M(i, q));
        for (int i = p + 1; i < q; ++i) rotate(M(p, i), M(i, q));
        for (int i = q + 1; i < kSize; ++i) rotate(M(p, i), M(q, i));
        for (int i = 0; i < kSize; ++i) rotate(r.U(i, p), r.U(i, q));
      }
    }
  }
  r.lambda = M.diagonal();
  sort_ascending(r);
  return r;
}

}  // namespace delos::riccati
