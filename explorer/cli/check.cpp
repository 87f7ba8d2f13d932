// delos check: are these scenes in order?
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/field/fusion.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct CheckCommand {
  SceneOptions options;
  std::vector<std::filesystem::path> scenes;
};

int run(const CheckCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  int exit_code = kDone;
  for (const auto& file : command.scenes) {
    try {
      const LoadedScene loaded = load(file, command.options, plugins);
      const FusionSolver solver(loaded.system, solver_named(command.options.solver));
      const std::string problem = metric_problem(loaded.system, loaded.metric);
      if (!problem.empty()) throw std::invalid_argument(problem);
      std::int64_t samples = 0;
      for (const SampleSet& set : loaded.scene.samples) samples += sample_count(set);
      const auto states = static_cast<std::size_t>(loaded.scene.motion.layout.size());
      std::cout << file.string() << ": in order; "
                << counted(loaded.system.devices.size(), "device") << ", "
                << counted(static_cast<std::size_t>(samples), "sample") << ", "
                << counted(states, "state") << ", " << to_string(loaded.system.fusion)
                << " fusion, solver " << to_string(solver.solver()) << "\n";
    } catch (const Failure& failure) {
      if (failure.code == kUsage) throw;
      if (!failure.message.empty()) std::cerr << failure.message << "\n";
      exit_code = kDiagnostics;
    } catch (const std::invalid_argument& error) {
      std::cerr << file.string() << ": error: " << error.what() << "\n";
      exit_code = kDiagnostics;
    }
  }
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
  app->footer("Example:\n  delos check scenes/*.yaml");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
