// The scalar chain whose reading is the mean of its coordinate over an exposure.
//
// Over the window of τ seconds that ends at an update, with q = 1 and x the state then,
//
//     z = (1/τ) ∫ x_0 ds + v = h x + η + v,  v ~ N(0, 1/λ)
//
//     h_j = (−τ)^j / (j+1)!
//     R_η = E[η²]    = τ^(2k−1) / ((2k+1) (k!)²)
//     N_i = E[w_i η] = (−1)^k τ^(2k−1−i) / (2k−i)!
//
// as the state s seconds ago was Σ_j (−s)^j x_j/j! but for the noise w that came in
// since, whose part in the mean is η. Because η depends on w, a reading is a little
// more than one of a combination of states.
//
// An approximation of the papers (model/exposure_model.h) is the same with h of the
// state at the update, N = 0 and another R_η.
//
// Every step is computed in a unit of time of the filter's memory, at least dt, in
// which all numbers are near one.
#pragma once

#include "riccati/chain_terms.h"

namespace delos::riccati {

/// chain_values() where sampling.exposure > 0.
template <int kOrder, bool kSlopes>
ChainTerms<kOrder> exposed_values(const Sampling& sampling, double lambda,
                                  CovarianceKind kind);

/// What is known of a chain becomes, lag seconds ℓ later without a reading,
///
///     A(ℓ) f A(ℓ)ᵀ + Q(ℓ),   A_ij = ℓ^(j−i)/(j−i)!,
///     Q_ij = ℓ^(2k−1−i−j) / ((2k−1−i−j) (k−1−i)! (k−1−j)!)
template <int kOrder, bool kSlopes>
inline void carry(double lag, ChainTerms<kOrder>& f) {
  constexpr double kFactorial[] = {1, 1, 2};
  double scale[2 * kOrder] = {1};  // powers of the lag
  for (int p = 1; p < 2 * kOrder; ++p) scale[p] = scale[p - 1] * lag;
  const auto at = [](int i, int j) {
    const int low = i < j ? i : j, high = i < j ? j : i;
    return low * kOrder - low * (low - 1) / 2 + high - low;
  };
  const ChainTerms<kOrder> before = f;
  for (int i = 0; i < kOrder; ++i) {
    for (int j = i; j < kOrder; ++j) {
      const int power = 2 * kOrder - 1 - i - j;
      double value = scale[power] /
                     (power * kFactorial[kOrder - 1 - i] * kFactorial[kOrder - 1 - j]);
      double slope = 0;
      for (int a = i; a < kOrder; ++a) {
        for (int b = j; b < kOrder; ++b) {
          const double part =
              scale[a - i] / kFactorial[a - i] * scale[b - j] / kFactorial[b - j];
          value += part * before.value[at(a, b)];
          if constexpr (kSlopes) slope += part * before.slope[at(a, b)];
        }
      }
      f.value[at(i, j)] = value;
      if constexpr (kSlopes) f.slope[at(i, j)] = slope;
    }
  }
}

/// f_ij(λ), and with kSlopes f_ij′(λ), in SI units, of either chain, after its lag.
template <int kOrder, bool kSlopes>
inline ChainTerms<kOrder> any_chain_values(const Sampling& sampling, double lambda,
                                           CovarianceKind kind) {
  ChainTerms<kOrder> f = sampling.exposure > 0
                             ? exposed_values<kOrder, kSlopes>(sampling, lambda, kind)
                             : chain_values<kOrder, kSlopes>(sampling, lambda, kind);
  if (sampling.lag > 0) carry<kOrder, kSlopes>(sampling.lag, f);
  return f;
}

}  // namespace delos::riccati
