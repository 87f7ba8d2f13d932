// The value of a place where the target is tried in several orientations.
#pragma once

#include <cmath>
#include <cstddef>

#include "delos/sampling/sets.h"

namespace delos {

/// One value from those of several orientations.
struct CombinedValue {
  double value = 0;
  std::size_t worst = 0;  ///< the first of the worst orientations
};

/// How many times a place is solved: the information of all orientations becomes one
/// before.
[[nodiscard]] constexpr std::size_t solved_turns(OrientationRule rule,
                                                 std::size_t turns) {
  return rule == OrientationRule::information ? 1 : turns;
}

/// @param turns how many values there are, ≥ 1: solved_turns()
/// @param at(turn) a value; +∞ where the orientation is blind, which is the worst of
/// any
///        metric
template <class At>
[[nodiscard]] CombinedValue combine(OrientationRule rule, std::size_t turns,
                                    bool larger_is_better, At&& at) {
  CombinedValue all;
  double sum = at(0), worst = sum;
  for (std::size_t t = 1; t < turns; ++t) {
    const double value = at(t);
    sum += value;
    const bool worse =
        std::isinf(value) ||
        (!std::isinf(worst) && (larger_is_better ? value < worst : value > worst));
    if (!worse) continue;
    worst = value;
    all.worst = t;
  }
  const bool mean = rule == OrientationRule::mean;
  all.value = mean ? sum / static_cast<double>(turns) : worst;
  return all;
}

}  // namespace delos
