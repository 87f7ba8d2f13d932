// The costs of samples as one number, and its slopes.
#pragma once

#include <span>

#include "delos/scene/search.h"

namespace delos {

/// Reduce costs c with weights w ≥ 0 that sum to 1.
///
///   mean        Σ w c
///   p_norm      (Σ w c^p)^(1/p)
///   soft_max    (M/s) log Σ w exp(s c/M),  M = Σ w c
///   percentile  the level-quantile, linear between neighbours
///   cvar        mean of the worst 1 − level of the weight
///   fraction    Σ w [c > limit]; soft: Σ w /(1 + exp(−(c − limit)/(|limit|/20)))
///
/// Source of cvar: Rockafellar, Uryasev (2000), J. Risk 2(3), 21–41.
/// @param soft fraction has slopes; the others are the same
/// @param[out] slopes ∂/∂c, or null
[[nodiscard]] double reduce(const ObjectiveTerm& term, std::span<const double> costs,
                            std::span<const double> weights, bool soft, double* slopes);

}  // namespace delos
