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
// Every step is computed in a unit of time of the filter's memory, at least dt, in
// which all numbers are near one.
#pragma once

#include "riccati/chain_terms.h"

namespace delos::riccati {

/// chain_values() where sampling.exposure > 0.
template <int kOrder, bool kSlopes>
ChainTerms<kOrder> exposed_values(const Sampling& sampling, double lambda,
                                  CovarianceKind kind);

/// f_ij(λ), and with kSlopes f_ij′(λ), in SI units, of either chain.
template <int kOrder, bool kSlopes>
inline ChainTerms<kOrder> any_chain_values(const Sampling& sampling, double lambda,
                                           CovarianceKind kind) {
  return sampling.exposure > 0 ? exposed_values<kOrder, kSlopes>(sampling, lambda, kind)
                               : chain_values<kOrder, kSlopes>(sampling, lambda, kind);
}

}  // namespace delos::riccati
