// What was measured beside what is predicted, as JSON (`compare-measured --json`).
#pragma once

#include "measured/windows.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// @param windows of the places
[[nodiscard]] Json measured_json(const measured::PosesComparison& answer,
                                 const std::vector<measured::Window>& windows,
                                 const LoadedScene& loaded);
[[nodiscard]] Json measured_json(const measured::ReadingsComparison& answer,
                                 const LoadedScene& loaded);

}  // namespace delos::session
