// The costs of samples as one number, and its slopes.
#pragma once

#include <optional>
#include <span>

#include "delos/scene/search.h"

namespace delos {

/// Reduce costs c, of which less is better, with weights w ≥ 0 that sum to 1. The
/// term's limit is one of costs too, and +∞ misses it.
///
///   mean        Σ w c
///   p_norm      (Σ w c^p)^(1/p)
///   soft_max    (M/s) log Σ w exp(s c/M),  M = Σ w c
///   percentile  the level-quantile, linear between neighbours
///   cvar        mean of the worst 1 − level of the weight
///   fraction    Σ w [c > limit]; soft: Σ w /(1 + exp(−(c − limit)/(|limit|/20)))
///
/// Source of cvar: Rockafellar, Uryasev (2000), J. Risk 2(3), 21–41.
///
/// What looks at the worst alone has no slope where that is blind. With a blur b from 1
/// to 0 all begin as means, or as nearly:
///
///   p_norm      a power of 1/b at most
///   soft_max    cvar of the worst b, until b is 0
///   maximum     the same; then soft_greatest(), s = kSharpest
///   percentile  the mean from level − b/2 to level + b/2
///   cvar        the mean of the worst b at least
///   fraction    its soft form, b |limit| wide at least
///
/// @param blur from 0 to 1; none: as it is judged
/// @param[out] slopes ∂/∂c, or null
[[nodiscard]] double reduce(const ObjectiveTerm& term, std::span<const double> costs,
                            std::span<const double> weights, std::optional<double> blur,
                            double* slopes);

}  // namespace delos
