// Choices that leave nothing blind.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "selection/field_cost.h"
#include "selection/polytope.h"

namespace delos {

/// A choice that the rules and decisions allow and that leaves nothing blind; nullopt:
/// there is none, or none was found by looking at some hundred thousand samples.
///
/// Candidates are chosen that leave the fewest directions blind, and left out where
/// that leads nowhere: where what is left to choose, all of it together, doesn't see
/// everything.
/// @param stop asked at each step: it is given up then
[[nodiscard]] std::optional<std::vector<char>> seeing_choice(
    FieldCost& cost, const ChoiceRules& rules, const std::vector<Decision>& decisions,
    const std::function<bool()>& stop);

/// Say how blind samples are judged. What is blind whatever is chosen has the guess.
/// Where a choice is found that leaves nothing else blind, others cost kBlindCost, so
/// that such a choice is certified among its like; else all blind samples have the
/// guess.
/// @returns that choice; empty: none
/// @param stop as above
[[nodiscard]] std::vector<char> judge_blind_samples(
    FieldCost& cost, const ChoiceRules& rules, const std::vector<Decision>& decisions,
    const std::function<bool()>& stop);

}  // namespace delos
