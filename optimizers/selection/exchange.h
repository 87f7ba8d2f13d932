// Whole choices made better by adding and by exchanging candidates.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "selection/cost.h"
#include "selection/polytope.h"

namespace delos {

/// A whole choice and its cost.
struct Choice {
  std::vector<char> chosen;  ///< one flag a candidate
  double cost = 0;           ///< +∞ where it doesn't observe everything
};

/// A choice that the rules allow: decided ones, then candidates in the order of a
/// preference as long as they fit.
/// @param preference one number a candidate, the largest first
[[nodiscard]] std::vector<char> rounded(const ChoiceRules& rules,
                                        const std::vector<Decision>& decisions,
                                        std::span<const double> preference);

/// The cost of a whole choice. @see ChoiceCost::value
[[nodiscard]] double cost_of(ChoiceCost& cost, std::span<const char> chosen);

/// Descend by single exchanges of open candidates, and additions that still fit, until
/// none helps.
///
/// f(v) ≥ f(x) + slope·(v − x) at a whole choice x too, so exchanges that this doesn't
/// promise to help can't help and aren't tried.
/// @param stop asked before each trial
void exchange(ChoiceCost& cost, const ChoiceRules& rules,
              const std::vector<Decision>& decisions, Choice& choice,
              const std::function<bool()>& stop);

}  // namespace delos
