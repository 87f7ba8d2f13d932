// delos check: are these scenes in order?
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/field/existence.h"
#include "delos/scene/definition.h"
#include "delos/steady/steady_solver.h"
#include "json.h"
#include "summary.h"
#include "warnings.h"

namespace delos::cli {
namespace {

struct CheckCommand {
  SceneOptions options;
  std::vector<std::filesystem::path> scenes;
};

/// A scene in order, in numbers.
struct Facts {
  std::size_t devices = 0, states = 0;
  std::size_t samples = 0;  ///< 0: adaptive, so that they aren't known yet
  std::string fusion, solver;
  Existence existence;
};

/// What came of checking one file.
struct Checked {
  std::filesystem::path file;
  Diagnostics diagnostics;
  std::optional<Facts> facts;  ///< empty where a diagnostic is an error
};

Facts facts_of(const LoadedScene& loaded, Solver chosen) {
  const auto solver = make_steady_solver(loaded.system, chosen);
  const std::string problem = metric_problem(loaded.system, loaded.metric);
  if (!problem.empty()) throw std::invalid_argument(problem);
  Facts facts;
  facts.devices = loaded.system.devices.size();
  facts.states = static_cast<std::size_t>(covariance_layout(loaded.scene).size());
  for (const SampleSet& set : loaded.scene.samples)
    facts.samples += static_cast<std::size_t>(sample_count(set));
  facts.fusion = to_string(loaded.system.fusion);
  facts.solver = to_string(solver->solver());
  // Enough to tell a part from a whole, few enough for the slowest solver.
  constexpr std::size_t kPlaces = 200;
  facts.existence = existence(loaded.scene, loaded.system, kPlaces);
  return facts;
}

/// @throws Failure kUsage
Checked check(const std::filesystem::path& file, const SceneOptions& options,
              PluginRegistry& plugins) {
  Checked checked{file, {}, {}};
  try {
    const auto loaded = load(file, options, plugins, checked.diagnostics);
    if (!loaded) return checked;
    checked.facts = facts_of(*loaded, solver_named(options.solver));
    const Diagnostics doubts = doubts_of(file, *loaded, plugins);
    checked.diagnostics.insert(checked.diagnostics.end(), doubts.begin(), doubts.end());
  } catch (const std::invalid_argument& error) {
    checked.diagnostics.push_back({{file.string()}, Severity::error, error.what()});
  }
  return checked;
}

void print(const Checked& checked) {
  for (const Diagnostic& d : checked.diagnostics) std::cerr << to_string(d) << "\n";
  if (!checked.facts) return;
  const Facts& facts = *checked.facts;
  std::cout << checked.file.string() << ": in order; "
            << counted(facts.devices, "device") << ", "
            << (facts.samples > 0 ? counted(facts.samples, "sample")
                                  : "adaptive samples")
            << ", " << counted(facts.states, "state") << ", " << facts.fusion
            << " fusion, solver " << facts.solver;
  if (const std::string exists = to_string(facts.existence); !exists.empty())
    std::cout << "; " << exists;
  std::cout << "\n";
}

Json to_json(const Checked& checked) {
  Json json{{"scene", checked.file.string()}, {"in_order", checked.facts.has_value()}};
  if (checked.facts) {
    const Facts& facts = *checked.facts;
    json["devices"] = facts.devices;
    json["samples"] = facts.samples > 0 ? Json(facts.samples) : Json();
    json["states"] = facts.states;
    json["fusion"] = facts.fusion;
    json["solver"] = facts.solver;
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

int run(const CheckCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  int exit_code = kDone;
  Json json = Json::array();
  for (const auto& file : command.scenes) {
    const Checked checked = check(file, command.options, plugins);
    if (!checked.facts) exit_code = kDiagnostics;
    if (command.options.json)
      json.push_back(to_json(checked));
    else
      print(checked);
  }
  // A file's name may hold any bytes.
  if (command.options.json) print_document(json);
  return exit_code;
}

}  // namespace

void add_check_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<CheckCommand>();
  CLI::App* app = program.add_subcommand("check", "Are these scenes in order?");
  app->add_option("scenes", command->scenes, "Scene files")->required();
  app->add_option("--set", command->options.set,
                  "Change a value: PATH=VALUE, repeatable")
      ->allow_extra_args(false);
  app->add_option("--plugin-dir", command->options.plugin_dirs,
                  "Folder with device plugins, searched first; repeatable")
      ->allow_extra_args(false);
  app->add_flag("--json", command->options.json,
                "One JSON document on stdout, nothing else");
  app->footer("Example:\n  delos check scenes/*.yaml");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
