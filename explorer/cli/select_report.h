// What was chosen, for people and for scripts.
#pragma once

#include <iosfwd>

#include "delos/optimize/choices.h"
#include "delos/optimize/cover_scene.h"
#include "json.h"

namespace delos::cli {

/// The contract's document: `select --json`.
[[nodiscard]] Json select_json(const SelectResult& result);
void print_selection(std::ostream& out, const SelectResult& result);

/// The same of the fewest that see everything.
[[nodiscard]] Json cover_json(const SceneCover& cover);
void print_cover(std::ostream& out, const SceneCover& cover);

/// The band of values and bounds over counts.
[[nodiscard]] Json curve_json(const CountCurve& curve);
void print_curve(std::ostream& out, const CountCurve& curve);

/// What can go, and what that costs.
[[nodiscard]] Json removal_json(const RemovalOrder& order);
void print_removals(std::ostream& out, const RemovalOrder& order);

}  // namespace delos::cli
