// What each term of a weighted objective is worth, of several designs.
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

#include "session/json.h"
#include "session/scene_changes.h"

namespace delos::session {

/// {terms: [{name, unit}], values: [[number a term] a design]}, each term as if it were
/// the whole objective, without its weight and in its metric's unit: what is maximized
/// has no sign that minimising gives it.
/// @param designs values of the scene's variables
/// @param samples that a search looks at, see ProblemOptions
/// @param stop    set: the rest isn't of use any more; may be null
/// @throws std::invalid_argument as Problem, or a design has a variable that the scene
///         doesn't
[[nodiscard]] Json term_values(const Scene& scene,
                               const std::vector<VariableValues>& designs,
                               std::size_t samples, int threads,
                               const std::atomic<bool>* stop, PluginRegistry& plugins);

}  // namespace delos::session
