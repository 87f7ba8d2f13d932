// What was chosen among candidates, as the contract's documents.
#pragma once

#include <string>
#include <vector>

#include "delos/optimize/choices.h"
#include "delos/optimize/cover_scene.h"
#include "session/json.h"

namespace delos::session {

/// The names of those with these indices.
[[nodiscard]] std::vector<std::string> chosen_names(
    const CandidateScene& all, const std::vector<std::size_t>& chosen);
/// value/bound − 1; 0 where both are 0.
[[nodiscard]] double gap_of(double value, double bound);

/// `select --json`
[[nodiscard]] Json select_json(const SelectResult& result);
/// The same of the fewest that see everything.
[[nodiscard]] Json cover_json(const SceneCover& cover);
/// The band of values and bounds over counts.
[[nodiscard]] Json curve_json(const CountCurve& curve);
/// What can go, and what that costs.
[[nodiscard]] Json removal_json(const RemovalOrder& order);

}  // namespace delos::session
