// delos select: a choice of candidates, and how far from the best possible it is.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/format.h"
#include "evaluation.h"
#include "json.h"
#include "select_report.h"
#include "session/select_answer.h"
#include "session/written_field.h"
#include "status_line.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct SelectCommand {
  SceneOptions options;
  SelectOptions search;
  std::filesystem::path scene;
  std::vector<std::filesystem::path> out;
  std::filesystem::path envelope;
  std::string counts;
  bool remove = false;
};

/// The best so far and its bound, on a line of stderr.
class BoundLine {
 public:
  explicit BoundLine(const Scene& scene) : line_(scene.name) {}
  void update(const SelectProgress& at, const std::string& unit) {
    const auto text = [&](double x) {
      return std::isfinite(x) ? format_quantity(x, unit) : std::string("none yet");
    };
    if (at.ready < 1)
      return line_.update("candidates asked what they see: " +
                          format_quantity(100 * at.ready, "1", 2) + " %");
    line_.update(text(at.value) + ", at best " + text(at.lower_bound) + ", after " +
                 counted(at.nodes, "node"));
  }
  void clear() { line_.clear(); }

 private:
  StatusLine line_;
};

template <class Print>
void show(const SelectCommand& command, const Json& document, Print&& print) {
  if (command.options.json)
    print_document(document);
  else
    print();
}

/// "4..12"
std::pair<int, int> counts_of(const std::string& text) {
  int from = 0, to = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%d..%d%c", &from, &to, &rest) != 2)
    throw Failure{kUsage,
                  "--counts: expected two counts as in 4..12, not '" + text + "'"};
  return {from, to};
}

void write_envelope(const SelectCommand& command, const Scene& scene,
                    PluginRegistry& plugins) {
  const Field field = selection_envelope(scene, plugins, command.search);
  const std::string problem = write_field(field, command.envelope, {});
  if (!problem.empty()) throw Failure{kDiagnostics, problem};
}

/// The scene of what was chosen, and its field.
void write_chosen(const SelectCommand& command, const Scene& scene,
                  const LoadedScene& loaded, const Interrupt& interrupt) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  std::optional<Evaluation> evaluation;
  for (const auto& file : command.out) {
    std::string problem;
    if (is_scene(file)) {
      problem = save_scene(scene, command.scene.parent_path(), file);
    } else {
      const LoadedScene chosen{scene, build_system(scene, plugins), loaded.metric};
      if (!evaluation) evaluation = evaluate_scene(chosen, command.options, interrupt);
      problem = write_evaluation(*evaluation, scene, file, {});
    }
    if (!problem.empty()) throw Failure{kDiagnostics, problem};
  }
}

int run(SelectCommand& command) {
  const auto begin = std::chrono::steady_clock::now();
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const LoadedScene loaded = load(command.scene, command.options, plugins);
  const Samples samples = planned_samples(loaded.scene);
  for (const auto& file : command.out) {
    const std::string problem =
        is_scene(file) ? "" : drawable(loaded.scene, samples, file);
    if (!problem.empty()) throw Failure{kUsage, problem};
  }
  const Interrupt interrupt;
  BoundLine line(loaded.scene);
  command.search.threads = command.options.threads;
  command.search.cancel = &interrupt.requested();
  command.search.progress = [&](const SelectProgress& at) {
    line.update(at, loaded.metric.unit);
  };
  const auto refusable = [&](auto&& body) {
    try {
      return body();
    } catch (const std::invalid_argument& refusal) {
      line.clear();
      if (interrupt.requested())
        throw Failure{kCancelled, "stopped before there was a choice"};
      throw Failure{kDiagnostics, command.scene.string() + ": " + refusal.what()};
    } catch (const std::runtime_error& failure) {
      line.clear();
      throw Failure{kDiagnostics, failure.what()};
    }
  };
  if (loaded.scene.selection.cover) {
    // Where there are very many candidates, reading the scene takes seconds too.
    const std::chrono::duration<double> read = std::chrono::steady_clock::now() - begin;
    command.search.seconds = std::max(0.1, command.search.seconds - read.count());
    const SceneCover cover =
        refusable([&] { return cover_scene(loaded.scene, plugins, command.search); });
    line.clear();
    show(command, cover_json(cover), [&] { print_cover(std::cout, cover); });
    write_chosen(command, chosen_scene(cover.all, cover.chosen), loaded, interrupt);
    return interrupt.requested() ? kCancelled : kDone;
  }
  if (!command.envelope.empty())
    refusable([&] { write_envelope(command, loaded.scene, plugins); });
  if (!command.counts.empty()) {
    const auto counts = counts_of(command.counts);
    const CountCurve curve = refusable([&] {
      return count_curve(loaded.scene, plugins, command.search, counts.first,
                         counts.second);
    });
    line.clear();
    show(command, curve_json(curve), [&] { print_curve(std::cout, curve); });
    return interrupt.requested() ? kCancelled : kDone;
  }
  if (command.remove) {
    const RemovalOrder order =
        refusable([&] { return removal_order(loaded.scene, plugins, command.search); });
    line.clear();
    show(command, removal_json(order), [&] { print_removals(std::cout, order); });
    return interrupt.requested() ? kCancelled : kDone;
  }
  const SelectResult result =
      refusable([&] { return select(loaded.scene, plugins, command.search); });
  line.clear();
  show(command, select_json(result), [&] { print_selection(std::cout, result); });
  write_chosen(command, chosen_scene(result.all, result.chosen), loaded, interrupt);
  if (result.stop != SelectStop::cancelled) return kDone;
  std::cerr << "delos: stopped; this is the best so far\n";
  return kCancelled;
}

}  // namespace

void add_select_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<SelectCommand>();
  CLI::App* app = program.add_subcommand(
      "select", "Choose among candidates, and prove how good the choice is");
  app->add_option("scene", command->scene, "Scene file with a selection")->required();
  app->add_option("--gap", command->search.gap,
                  "Be satisfied so near to the bound, relative; 0: the best choice")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app->add_option("--seconds", command->search.seconds,
                  "Stop after about so long with the best choice and bound so far")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app->add_option("--samples", command->search.samples,
                  "Samples that are looked at, and that the bound is about; 0: all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app->add_option("--seed", command->search.seed, "Seed of all that is random")
      ->capture_default_str();
  app->add_option(
         "--out", command->out,
         "Write the scene with what was chosen (.yaml), for optimize to polish, "
         "or its field (.png, .csv, …); repeatable")
      ->allow_extra_args(false);
  app->add_option("--study", command->search.study,
                  "Keep the search in this file, and go on from it where it exists");
  app->add_option("--counts", command->counts,
                  "Instead: the best value and its bound for each count, as 4..12");
  app->add_flag("--remove", command->remove,
                "Instead: the order in which to do without candidates");
  app->add_option("--envelope", command->envelope,
                  "Write the field of the least that any choice could reach at each "
                  "sample by itself (.png, .csv, …)");
  add_scene_options(*app, command->options);
  app->footer(
      "Examples:\n"
      "  delos select scenes/12-ceiling-anchors.yaml\n"
      "  delos select scenes/12-ceiling-anchors.yaml --set selection.count=20 --json\n"
      "  delos select scenes/12-ceiling-anchors.yaml --out chosen.yaml --out "
      "chosen.png\n"
      "  delos select scenes/14-camera-cover.yaml     the fewest that see everything\n"
      "  delos select scenes/hiball/strips.yaml --remove\n"
      "  delos select scenes/13-camera-spots.yaml --counts 3..8\n"
      "  delos optimize chosen.yaml                   then move what was chosen");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
