// Words that choose how something is computed.
#pragma once

#include <string>

#include "delos/field/evaluate.h"
#include "delos/geometry/scattered.h"
#include "delos/simulation/filter.h"

namespace delos::session {

/// "auto", "spectral", "doubling" or "eigenvector".
/// @throws Refusal of the question: it is none of them
[[nodiscard]] Solver solver_named(const std::string& name);

/// "extended", "iterated", "sequential" or "unscented".
/// @throws Refusal of the question: it is none of them
[[nodiscard]] FilterKind filter_named(const std::string& name);

/// As to_string(ScatteredMethod).
/// @param what it is the value of
/// @throws Refusal of the question: it is none of them
[[nodiscard]] ScatteredMethod scattered_method_named(const std::string& name,
                                                     const char* what);

/// 0, 1 or 2 of "x", "y" or "z".
/// @throws Refusal of the question: it is none of them
[[nodiscard]] int axis_named(const std::string& name, const char* what);

}  // namespace delos::session
