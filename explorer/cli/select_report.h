// What was chosen, for people.
#pragma once

#include <iosfwd>

#include "session/select_answer.h"

namespace delos::cli {

using session::chosen_names;
using session::cover_json;
using session::curve_json;
using session::gap_of;
using session::removal_json;
using session::select_json;

void print_selection(std::ostream& out, const SelectResult& result);

/// The same of the fewest that see everything.
void print_cover(std::ostream& out, const SceneCover& cover);

/// The band of values and bounds over counts.
void print_curve(std::ostream& out, const CountCurve& curve);

/// What can go, and what that costs.
void print_removals(std::ostream& out, const RemovalOrder& order);

}  // namespace delos::cli
