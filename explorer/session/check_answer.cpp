#include "session/check_answer.h"

#include <stdexcept>

#include "delos/field/doubts.h"
#include "delos/field/evaluate.h"
#include "delos/sampling/samples.h"
#include "delos/scene/definition.h"
#include "delos/scene/presets.h"
#include "session/diagnostics_json.h"

namespace delos::session {
namespace {

SceneFacts facts_of(const LoadedScene& loaded, Solver chosen) {
  const auto solver = make_steady_solver(loaded.system, chosen);
  const std::string problem = metric_problem(loaded.system, loaded.metric);
  if (!problem.empty()) throw std::invalid_argument(problem);
  SceneFacts facts;
  facts.devices = loaded.system.devices.size();
  facts.states = static_cast<std::size_t>(covariance_layout(loaded.scene).size());
  for (const SampleSet& set : loaded.scene.samples)
    facts.samples += static_cast<std::size_t>(sample_count(set));
  facts.fusion = to_string(loaded.system.fusion);
  facts.solver = to_string(solver->solver());
  facts.presets = preset_sources(loaded.scene);
  // Enough to tell a part from a whole, few enough for the slowest solver.
  constexpr std::size_t kPlaces = 200;
  facts.existence = existence(loaded.scene, loaded.system, kPlaces);
  return facts;
}

}  // namespace

CheckedScene check_scene(const std::filesystem::path& file,
                         const std::vector<Override>& overrides,
                         PluginRegistry& plugins, Solver solver) {
  CheckedScene checked{file, {}, {}};
  try {
    const auto loaded = load(file, overrides, plugins, checked.diagnostics);
    if (!loaded) return checked;
    checked.facts = facts_of(*loaded, solver);
    const Diagnostics doubts = doubts_of(file, *loaded, plugins);
    checked.diagnostics.insert(checked.diagnostics.end(), doubts.begin(), doubts.end());
  } catch (const std::invalid_argument& error) {
    checked.diagnostics.push_back({{file.string()}, Severity::error, error.what()});
  }
  return checked;
}

Diagnostics doubts_of(const std::filesystem::path& file, const LoadedScene& loaded,
                      PluginRegistry& plugins) {
  return warnings_of(file, doubts(loaded.scene, loaded.system, plugins), plugins);
}

Json check_json(const CheckedScene& checked) {
  Json json{{"scene", checked.file.string()}, {"in_order", checked.facts.has_value()}};
  if (checked.facts) {
    const SceneFacts& facts = *checked.facts;
    json["devices"] = facts.devices;
    json["samples"] = facts.samples > 0 ? Json(facts.samples) : Json();
    json["states"] = facts.states;
    json["fusion"] = facts.fusion;
    json["solver"] = facts.solver;
    if (!facts.presets.empty()) json["presets"] = facts.presets;
    const Existence& exists = facts.existence;
    if (exists.places > 0)
      json["existence"] = {{"places", exists.places},
                           {"detectable", exists.detectable},
                           {"stabilizable", exists.stabilizable},
                           {"undriven", exists.undriven}};
  }
  json["diagnostics"] = diagnostics_json(checked.diagnostics);
  return json;
}

}  // namespace delos::session
