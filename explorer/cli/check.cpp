// delos check: are these scenes in order?
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/words.h"
#include "json.h"
#include "session/check_answer.h"
#include "session/named.h"

namespace delos::cli {
namespace {

struct CheckCommand {
  SceneOptions options;
  std::vector<std::filesystem::path> scenes;
};

void print(const session::CheckedScene& checked) {
  for (const Diagnostic& d : checked.diagnostics) std::cerr << to_string(d) << "\n";
  if (!checked.facts) return;
  const session::SceneFacts& facts = *checked.facts;
  std::cout << checked.file.string() << ": in order; "
            << counted(facts.devices, "device") << ", "
            << (facts.samples > 0 ? counted(facts.samples, "sample")
                                  : "adaptive samples")
            << ", " << counted(facts.states, "state") << ", " << facts.fusion
            << " fusion, solver " << facts.solver;
  if (const std::string exists = to_string(facts.existence); !exists.empty())
    std::cout << "; " << exists;
  std::cout << "\n";
  for (const std::string& preset : facts.presets)
    std::cout << "  preset " << preset << "\n";
}

int run(const CheckCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  int exit_code = kDone;
  Json json = Json::array();
  for (const auto& file : command.scenes) {
    const session::CheckedScene checked =
        session::check_scene(file, overrides_of(command.options), plugins,
                             session::solver_named(command.options.solver));
    if (!checked.facts) exit_code = kDiagnostics;
    if (command.options.json)
      json.push_back(session::check_json(checked));
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
