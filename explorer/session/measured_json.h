// What was measured beside what is predicted, as JSON (`compare-measured --json`).
#pragma once

#include "measured/comparison.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

[[nodiscard]] Json measured_json(const measured::PosesComparison& answer,
                                 const LoadedScene& loaded);
[[nodiscard]] Json measured_json(const measured::ReadingsComparison& answer,
                                 const LoadedScene& loaded);

}  // namespace delos::session
