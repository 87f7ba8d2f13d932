// What a search found, as values and as the contract's documents.
#pragma once

#include <string>
#include <vector>

#include "delos/optimize/answers.h"
#include "delos/optimize/optimize.h"
#include "delos/scene/number.h"
#include "session/json.h"

namespace delos::session {

/// "mean eigmax"
[[nodiscard]] std::string objective_text(const Scene& scene);
/// The objective's unit, "1" where terms have several.
[[nodiscard]] std::string objective_unit(const Scene& scene);
/// What a maximised objective is, without the sign that minimising gave it.
[[nodiscard]] double objective_shown(const Scene& scene, double objective);
/// The SI unit of a constraint's slack.
[[nodiscard]] std::string constraint_unit(const ConstraintEntry& entry,
                                          const Scene& scene);

/// A variable of the scene. @pre there is one
[[nodiscard]] SceneNumber variable_of(Scene& scene, const std::string& path,
                                      PluginRegistry& plugins);

/// {path: value in SI} of all variables.
[[nodiscard]] Json variables_json(Scene scene, PluginRegistry& plugins);
/// [{name, satisfied, slack}]
[[nodiscard]] Json constraints_json(const std::vector<ConstraintReport>& constraints);

/// The contract's document: `optimize --json`.
[[nodiscard]] Json search_json(const OptimizeResult& result, PluginRegistry& plugins);
/// What the design depends on: `answers` of the document.
[[nodiscard]] Json answers_json(const Answers& answers);

}  // namespace delos::session
