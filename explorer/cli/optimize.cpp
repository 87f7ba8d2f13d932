// delos optimize: better values for the variables of a scene.

#include <cstdio>
#include <memory>
#include <optional>

#include "command.h"
#include "evaluation.h"
#include "search_report.h"
#include "session/joined_crew.h"
#include "session/search_answer.h"
#include "session/study_answer.h"
#include "session/written_field.h"
#include "warnings.h"

namespace delos::cli {
namespace {

struct OptimizeCommand {
  SceneOptions options;
  OptimizeOptions search;
  std::filesystem::path scene;
  std::vector<std::filesystem::path> out, before;
  std::filesystem::path study;
  std::string shard;
  bool explain = false;
};

/// What can't be written is said before the search.
void check_outputs(const OptimizeCommand& command, const Scene& scene) {
  const Samples samples = planned_samples(scene);
  for (const auto* list : {&command.out, &command.before}) {
    for (const auto& file : *list) {
      if (list == &command.out && is_scene(file)) continue;
      const std::string problem = drawable(scene, samples, file);
      if (!problem.empty()) throw Failure{kUsage, problem};
    }
  }
}

void write_fields(const std::vector<std::filesystem::path>& files,
                  const LoadedScene& loaded, const SceneOptions& options,
                  const std::filesystem::path& folder, const Interrupt& interrupt) {
  std::optional<Evaluation> evaluation;
  PictureOptions picture;
  picture.larger_is_better = loaded.metric.larger_is_better;
  picture.devices = markers_of(loaded.scene, loaded.system);
  for (const auto& file : files) {
    std::string problem;
    if (is_scene(file)) {
      problem = save_scene(loaded.scene, folder, file);
    } else {
      if (!evaluation) evaluation = evaluate_scene(loaded, options, interrupt);
      problem = write_evaluation(*evaluation, loaded.scene, file, picture);
    }
    if (!problem.empty()) throw Failure{kDiagnostics, problem};
  }
}

OptimizeResult search(OptimizeCommand& command, const Scene& scene,
                      PluginRegistry& plugins) {
  if (command.study.empty()) return optimize(scene, plugins, command.search);
  const OptimizeOptions& s = command.search;
  return Study::create(command.study, scene, command.scene.parent_path(),
                       {s.algorithm, s.evaluations, s.starts, s.seed, s.samples,
                        DELOS_VERSION, s.parts},
                       plugins)
      .run(command.search);
}

/// "2/3": the second of three parts.
SearchPart part_named(const OptimizeCommand& command) {
  if (command.shard.empty()) return {};
  std::size_t part = 0, of = 0;
  char rest = 0;
  if (std::sscanf(command.shard.c_str(), "%zu/%zu%c", &part, &of, &rest) != 2 ||
      part < 1 || part > of || of > 10000)
    throw Failure{kUsage, "--shard '" + command.shard +
                              "': write PART/PARTS, as 2/3 for the second of three"};
  if (command.study.empty())
    throw Failure{kUsage, "--shard needs --study FILE, for delos merge to read"};
  return {part - 1, of};
}

int run(OptimizeCommand& command) {
  command.search.parts = part_named(command);
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const session::JoinedCrew crew(command.options.threads);
  if (crew.served(plugins)) return kDone;
  if (crew.get() && !command.shard.empty())
    throw Failure{kUsage, "--shard and mpirun both divide the starts; use one of them"};
  command.search.crew = crew.get();
  LoadedScene loaded = load(command.scene, command.options, plugins);
  check_outputs(command, loaded.scene);
  const Diagnostics warnings = print_doubts(command.scene, loaded, plugins);

  const Interrupt interrupt;
  SearchLine line(loaded.scene);
  command.search.threads = crew.threads();
  command.search.cancel = &interrupt.requested();
  command.search.progress = [&](const SearchProgress& at) { line.update(at); };
  std::function<Answers(const OptimizeResult&)> explain;
  if (command.explain) {
    explain = [&](const OptimizeResult& found) {
      Problem problem(found.scene, plugins, {kAnswerSamples, command.search.threads});
      constexpr double kLoss = 0.05;
      return answers(problem, problem.design().start(), kLoss, command.search.cancel);
    };
  }
  std::optional<OptimizeResult> result;
  const int code = finish_search(
      [&] {
        result = search(command, loaded.scene, plugins);
        return *result;
      },
      line, command.scene, command.study, plugins, command.options.json, explain,
      warnings);

  const std::filesystem::path folder = command.scene.parent_path();
  write_fields(command.before, loaded, command.options, folder, interrupt);
  LoadedScene best{result->scene, build_system(result->scene, plugins), loaded.metric};
  write_fields(command.out, best, command.options, folder, interrupt);
  return code;
}

}  // namespace

void add_optimize_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<OptimizeCommand>();
  CLI::App* app = program.add_subcommand(
      "optimize", "Search for better values of a scene's variables");
  app->add_option("scene", command->scene,
                  "Scene file with variables, and an objective and constraints")
      ->required();
  app->add_option("--algorithm", command->search.algorithm,
                  "auto, or one of NLopt's: slsqp, mma, ccsa, lbfgs, cobyla, bobyqa, …")
      ->check(CLI::IsMember(algorithm_names()))
      ->capture_default_str();
  app->add_option("--evaluations", command->search.evaluations,
                  "Evaluations at most; 0: by the number of variables")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app->add_option(
         "--starts", command->search.starts,
         "Searches from different designs; 0: 4, or 16 where a worst sample decides")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  app->add_option("--seed", command->search.seed, "Seed of all that is random")
      ->capture_default_str();
  app->add_option("--samples", command->search.samples,
                  "Samples looked at while searching; the result is judged on all")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app->add_option(
      "--study", command->study,
      "Keep the search in this new file; delos study resumes and steers it");
  app->add_option(
         "--shard", command->shard,
         "Only this part of the starts, as 2/3; delos merge joins their studies")
      ->type_name("PART/PARTS");
  app->add_flag(
      "--explain", command->explain,
      "Also how far each variable may be off, and which device is missed most");
  app->add_option(
         "--out", command->out,
         "Write the best scene (.yaml) or its field (.png, .csv, …); repeatable")
      ->allow_extra_args(false);
  app->add_option("--before", command->before,
                  "Write the field as it was, to compare; repeatable")
      ->allow_extra_args(false);
  add_scene_options(*app, command->options);
  app->footer(
      "Ctrl-C ends the search and keeps the best so far.\n"
      "Examples:\n"
      "  delos optimize scenes/09-camera-room.yaml --seed 1 --json\n"
      "  delos optimize scenes/09-camera-room.yaml --before before.png --out best.png "
      "\\\n"
      "        --out best.yaml\n"
      "  mpirun -n 8 delos optimize scenes/09-camera-room.yaml --starts 64");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
