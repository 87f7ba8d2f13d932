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
  double cost = 0;           ///< is_blind() where it doesn't observe everything
};

/// A choice that the rules allow: decided ones, then candidates in the order of a
/// preference as long as they fit.
/// @param preference one number a candidate, the largest first
[[nodiscard]] std::vector<char> rounded(const ChoiceRules& rules,
                                        const std::vector<Decision>& decisions,
                                        std::span<const double> preference);

/// The cost of a whole choice. @see ChoiceCost::value
[[nodiscard]] double cost_of(ChoiceCost& cost, std::span<const char> chosen);

/// Descend by single additions and exchanges of open candidates, the most promising
/// first, until none of those tried helps.
/// @param stop asked now and then
void exchange(ChoiceCost& cost, const ChoiceRules& rules,
              const std::vector<Decision>& decisions, Choice& choice,
              const std::function<bool()>& stop);

}  // namespace delos
