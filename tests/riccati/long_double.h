// References in long double (64 bits of mantissa): slow, plain, independent of the
// kernel.
#pragma once

#include <Eigen/Dense>

namespace delos::testing {

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// A and Q of the scalar chain of order k over dt, and S = λ e₀ e₀ᵀ.
struct LongChain {
  LongMatrix A, Q, S;
  LongChain(int k, long double dt, long double lambda)
      : A(LongMatrix::Zero(k, k)), Q(A), S(A) {
    const auto factorial = [](int n) {
      long double f = 1;
      for (int i = 2; i <= n; ++i) f *= i;
      return f;
    };
    for (int i = 0; i < k; ++i) {
      for (int j = 0; j < k; ++j) {
        if (j >= i)
          A(i, j) = std::pow(dt, static_cast<long double>(j - i)) / factorial(j - i);
        const int p = 2 * k - 1 - i - j;
        Q(i, j) = std::pow(dt, static_cast<long double>(p)) /
                  (p * factorial(k - 1 - i) * factorial(k - 1 - j));
      }
    }
    S(0, 0) = lambda;
  }
};

/// P∞ by doubling as printed in Chu, Fan, Lin, Wang (2004), dual form:
/// A ← A W⁻¹ A, G ← G + A W⁻¹ G Aᵀ, H ← H + Aᵀ H W⁻¹ A with W = I + G H.
inline LongMatrix long_prior(const LongMatrix& A0, const LongMatrix& Q,
                             const LongMatrix& S) {
  const LongMatrix I = LongMatrix::Identity(A0.rows(), A0.cols());
  LongMatrix A = A0.transpose(), G = S, H = Q;
  for (int i = 0; i < 60; ++i) {
    const LongMatrix W = (I + G * H).inverse();
    const LongMatrix more = A.transpose() * H * W * A;
    G += (A * W * G * A.transpose()).eval();
    A = (A * W * A).eval();
    H += (more + more.transpose()) / 2;
    if (more.cwiseAbs().maxCoeff() == 0) break;
  }
  return H;
}

inline LongMatrix long_posterior(const LongMatrix& P, const LongMatrix& S) {
  const LongMatrix I = LongMatrix::Identity(P.rows(), P.cols());
  return (I + P * S).inverse() * P;
}

}  // namespace delos::testing
