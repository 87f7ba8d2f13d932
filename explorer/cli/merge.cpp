// delos merge: one study from those of parts.
#include <memory>

#include "command.h"
#include "search_report.h"
#include "session/refusal.h"

namespace delos::cli {
namespace {

struct MergeCommand {
  std::filesystem::path study;
  std::vector<std::filesystem::path> parts, plugin_dirs;
  int threads = 0;
  bool json = false;
};

int run(const MergeCommand& command) {
  PluginRegistry plugins(plugin_folders(command.plugin_dirs));
  const auto merged = [&] {
    try {
      return Study::merge(command.study, command.parts, plugins);
    } catch (const std::logic_error& refusal) {
      throw Failure{kDiagnostics, refusal.what()};
    } catch (const std::runtime_error& failure) {
      throw Failure{kDiagnostics, failure.what()};
    }
  };
  Study study = merged();
  const Interrupt interrupt;
  SearchLine line(study.scene());
  OptimizeOptions options;
  options.threads = command.threads;
  options.cancel = &interrupt.requested();
  options.progress = [&](const SearchProgress& at) { line.update(at); };
  return finish_search([&] { return study.run(options); }, line, command.study,
                       command.study, plugins, command.json);
}

}  // namespace

void add_merge_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<MergeCommand>();
  CLI::App* app = program.add_subcommand(
      "merge", "One study from those of delos optimize --shard, and its result");
  app->add_option("study", command->study, "New file")->required();
  app->add_option("parts", command->parts, "The studies of all parts")->required();
  app->add_option("--plugin-dir", command->plugin_dirs,
                  "Folder with device plugins, searched first; repeatable")
      ->allow_extra_args(false);
  app->add_option("--threads", command->threads, "Threads; 0: one a core")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  app->add_flag("--json", command->json, "One JSON document on stdout, nothing else");
  app->footer(
      "Example, on two machines and then on one:\n"
      "  delos optimize scenes/09-camera-room.yaml --shard 1/2 --study one.study\n"
      "  delos optimize scenes/09-camera-room.yaml --shard 2/2 --study two.study\n"
      "  delos merge room.study one.study two.study");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
