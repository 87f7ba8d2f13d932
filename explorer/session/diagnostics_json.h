// Findings for scripts.
#pragma once

#include "delos/document/diagnostic.h"
#include "session/json.h"

namespace delos::session {

/// A list of {severity, file, line, column, message}.
[[nodiscard]] Json diagnostics_json(const Diagnostics& diagnostics);

}  // namespace delos::session
