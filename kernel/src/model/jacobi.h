// Eigenvalues of a small symmetric matrix by Jacobi rotations.
//
// Chosen over tridiagonal QR for its accuracy: on a positive definite matrix the
// stopping rule |m_pq| ≤ ε √(m_pp m_qq) finds small eigenvalues to the relative
// accuracy that the matrix itself holds, however widely its diagonal is graded. Source:
// Demmel, Veselić (1992), "Jacobi's method is more accurate than QR",
//         SIAM J. Matrix Anal. Appl. 13(4), 1204–1245, doi:10.1137/0613074.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <utility>

#include "model/epsilon.h"

namespace delos {

/// Six sweeps are the most ever seen; this many stop NaNs.
inline constexpr int kMaxSweeps = 30;

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

/// All pairs p < q in the order of a round-robin tournament: neighbours in the list
/// share no index where possible, so that a processor can overlap their long square
/// roots.
template <int kSize>
constexpr auto rotation_order() {
  std::array<std::pair<int, int>, kSize*(kSize - 1) / 2> order{};
  const int m = kSize + kSize % 2 - 1;  // rounds; player m stays where it is
  int count = 0;
  for (int round = 0; round < m; ++round) {
    for (int i = 0; i <= m / 2; ++i) {
      int a = (round + i) % m, b = i == 0 ? m : (round + m - i) % m;
      if (a > b) std::swap(a, b);
      if (b < kSize) order[count++] = {a, b};
    }
  }
  return order;
}

/// Zeroes m_pq where it matters. Indices are template arguments for speed: everything
/// stays in registers, and a sweep is three times as fast as with loops over p and q.
/// @returns whether it rotated
template <int p, int q, int kSize>
[[gnu::always_inline]] inline bool jacobi_rotate(Eigen::Matrix<double, kSize, kSize>& M,
                                                 Eigen::Matrix<double, kSize, kSize>& U,
                                                 double floor) {
  const double x = M(p, q), mp = M(p, p), mq = M(q, q);
  if (x * x <= kEps * kEps * std::abs(mp * mq) || std::abs(x) <= floor) return false;

  // t = tan of the smaller angle that zeroes m_pq = 2x/(h ± √(h² + 4x²)) = y/u.
  const double h = mq - mp, y = 2 * x;
  double t, c, s;
  if (std::abs(x) < 2e-4 * std::abs(h)) {
    // The last sweep's small angles by their series, without the wait for square roots:
    // the terms left out are below 2 r⁵ < 1e-18.
    const double r = x / h;
    t = r * (1 - r * r);
    c = 1 - t * t * (0.5 - 0.375 * t * t);
    s = t * c;
  } else {
    const double u = h + std::copysign(std::sqrt(h * h + y * y), h);
    const double norm = 1 / std::sqrt(u * u + y * y);
    t = y / u;
    c = std::abs(u) * norm;
    s = std::copysign(y, y * u) * norm;
  }
  M(p, p) = mp - t * x;
  M(q, q) = mq + t * x;
  M(p, q) = 0;
  const auto rotate = [c, s](double& a, double& b) {
    const double old = a;
    a = c * old - s * b;
    b = s * old + c * b;
  };
#pragma GCC unroll 6
  for (int i = 0; i < p; ++i) rotate(M(i, p), M(i, q));
#pragma GCC unroll 6
  for (int i = p + 1; i < q; ++i) rotate(M(p, i), M(i, q));
#pragma GCC unroll 6
  for (int i = q + 1; i < kSize; ++i) rotate(M(p, i), M(q, i));
#pragma GCC unroll 6
  for (int i = 0; i < kSize; ++i) rotate(U(i, p), U(i, q));
  return true;
}

/// A power of two that brings a matrix to where squares of its entries are numbers: 1
/// for nearly all, and no other digit changes.
/// @param largest of its diagonal entries, in magnitude
inline double range_factor(double largest) {
  const double shrink = largest > 0x1p+400 ? 0x1p-600 : 1.0;
  return largest < 0x1p-400 && largest > 0 ? 0x1p+600 : shrink;
}

/// Rotate M to diagonal form and the columns of U along with it.
/// @param M symmetric; the upper triangle is read. Entries between 1e-150 and 1e150 in
///          magnitude or zero, for their squares are formed.
template <int kSize>
void jacobi_diagonalize(Eigen::Matrix<double, kSize, kSize>& M,
                        Eigen::Matrix<double, kSize, kSize>& U) {
  constexpr static auto kOrder = rotation_order<kSize>();
  // Far below any eigenvalue that is used.
  const double floor = kEps * kEps * M.diagonal().cwiseAbs().maxCoeff();
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    const int rotations = [&]<std::size_t... i>(std::index_sequence<i...>) {
      return (0 + ... + jacobi_rotate<kOrder[i].first, kOrder[i].second>(M, U, floor));
    }
    (std::make_index_sequence<kOrder.size()>{});
    if (rotations == 0) break;
  }
}

/// M = U diag(λ) Uᵀ, for entries of any size.
template <int kSize>
JacobiResult<kSize> jacobi_eigen(Eigen::Matrix<double, kSize, kSize> M) {
  JacobiResult<kSize> r;
  r.U.setIdentity();
  const double factor = range_factor(M.diagonal().cwiseAbs().maxCoeff());
  M *= factor;
  jacobi_diagonalize<kSize>(M, r.U);
  r.lambda = M.diagonal() / factor;
  sort_ascending(r);
  return r;
}

}  // namespace delos
