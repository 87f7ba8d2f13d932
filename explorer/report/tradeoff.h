// What delos tradeoff found, as a report shows it.
#pragma once

#include "session/json.h"

namespace delos::report {

/// {across: {name, unit}, of_limit, objective: {name, unit}, points: [{across, used,
///  objective, kept, dominated}], cheapest: {devices, price} or null}: the objective
/// against a limit and what is used of it, or against the number of devices and their
/// price. Points that weren't reached are left out.
/// @param document that `delos tradeoff --json` wrote
/// @throws std::invalid_argument it is something else
[[nodiscard]] session::Json tradeoff_json(const session::Json& document);

}  // namespace delos::report
