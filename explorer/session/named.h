// Words that choose how something is computed.
#pragma once

#include <string>

#include "delos/field/evaluate.h"
#include "delos/simulation/filter.h"

namespace delos::session {

/// "auto", "spectral", "doubling" or "eigenvector".
/// @throws Refusal of the question: it is none of them
[[nodiscard]] Solver solver_named(const std::string& name);

/// "extended", "iterated", "sequential" or "unscented".
/// @throws Refusal of the question: it is none of them
[[nodiscard]] FilterKind filter_named(const std::string& name);

}  // namespace delos::session
