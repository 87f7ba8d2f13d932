// delos select: a choice of candidates, and how far from the best possible it is.
#include "delos/optimize/select.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/output/format.h"
#include "delos/output/write.h"
#include "evaluation.h"
#include "json.h"
#include "status_line.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct SelectCommand {
  SceneOptions options;
  SelectOptions search;
  std::filesystem::path scene;
  std::vector<std::filesystem::path> out;
};

bool is_scene(const std::filesystem::path& file) {
  const std::string suffix = file.extension().string();
  return suffix == ".yaml" || suffix == ".yml";
}

std::vector<std::string> names_of(const SelectResult& result,
                                  const std::vector<char>& flags) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i]) names.push_back(result.all.candidates[i].name);
  return names;
}

std::vector<std::string> chosen_names(const SelectResult& result) {
  std::vector<std::string> names;
  for (const std::size_t i : result.chosen)
    names.push_back(result.all.candidates[i].name);
  return names;
}

Json select_json(const SelectResult& result) {
  Json fractions = Json::object();
  for (std::size_t i = 0; i < result.fractions.size(); ++i)
    if (result.fractions[i] > 1e-6)
      fractions[result.all.candidates[i].name] = number(result.fractions[i]);
  return {{"chosen", chosen_names(result)},
          {"value", number(result.value)},
          {"lower_bound", number(result.lower_bound)},
          {"gap", number(result.gap)},
          {"variance_gap", number(result.variance_gap)},
          {"certified", result.quantity},
          {"unit", result.unit},
          {"samples", result.samples},
          {"guess", number(result.guess)},
          {"candidates", result.all.candidates.size()},
          {"in_every", names_of(result, result.in_every)},
          {"in_none", names_of(result, result.in_none)},
          {"fractions", fractions},
          {"nodes", result.nodes},
          {"stop", to_string(result.stop)},
          {"seconds", number(result.seconds)}};
}

void print_names(std::ostream& out, const char* label,
                 const std::vector<std::string>& names) {
  constexpr std::size_t kWidth = 78;
  std::string line = std::string(14 - std::string_view(label).size(), ' ');
  out << "  " << label;
  std::size_t width = 2 + 14;
  for (const std::string& name : names) {
    if (width + name.size() + 1 > kWidth) {
      out << "\n" << std::string(16, ' ');
      width = 16;
      line.clear();
    }
    out << line << name;
    line = " ";
    width += name.size() + 1;
  }
  out << "\n";
}

void print_selection(std::ostream& out, const SelectResult& r) {
  const auto line = [&](const char* label) -> std::ostream& {
    return out << "  " << std::left << std::setw(14) << label;
  };
  out << r.all.scene.name << ": " << r.chosen.size() << " of "
      << counted(r.all.candidates.size(), "candidate") << "\n";
  line("value") << format_quantity(r.value, r.unit, 4) << ", " << r.quantity << "\n";
  line("lower bound") << format_quantity(r.lower_bound, r.unit, 4)
                      << ": no choice that the scene allows has less\n";
  line("gap") << std::setprecision(3) << 100 * r.gap << " %"
              << (r.unit.empty() ? "" : ", of variances ");
  if (!r.unit.empty()) out << std::setprecision(3) << 100 * r.variance_gap << " %";
  out << ", after " << r.nodes << " nodes and " << r.seconds << " s\n";
  print_names(out, "chosen", chosen_names(r));
  std::vector<std::string> every;
  for (std::size_t i = 0; i < r.in_every.size(); ++i)
    if (r.in_every[i] && !r.all.candidates[i].kept)
      every.push_back(r.all.candidates[i].name);
  if (!every.empty()) print_names(out, "in every one", every);
  const auto none = std::count(r.in_none.begin(), r.in_none.end(), 1);
  if (none > 0)
    line("in none") << counted(static_cast<std::size_t>(none), "candidate")
                    << " of the choices that are as good\n";
}

/// The best so far and its bound, on a line of stderr.
class BoundLine {
 public:
  explicit BoundLine(const Scene& scene) : line_(scene.name) {}
  void update(const SelectProgress& at, const std::string& unit) {
    const auto text = [&](double x) {
      return std::isfinite(x) ? format_quantity(x, unit) : std::string("none yet");
    };
    line_.update(text(at.value) + ", at best " + text(at.lower_bound) + ", after " +
                 counted(at.nodes, "node"));
  }
  void clear() { line_.clear(); }

 private:
  StatusLine line_;
};

int run(SelectCommand& command) {
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
  SelectResult result;
  try {
    result = select(loaded.scene, plugins, command.search);
  } catch (const std::invalid_argument& refusal) {
    line.clear();
    throw Failure{kDiagnostics, command.scene.string() + ": " + refusal.what()};
  }
  line.clear();
  if (command.options.json)
    std::cout << select_json(result).dump(2) << "\n";
  else
    print_selection(std::cout, result);

  const Scene scene = chosen_scene(result.all, result.chosen);
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
  add_scene_options(*app, command->options);
  app->footer(
      "Examples:\n"
      "  delos select scenes/12-ceiling-anchors.yaml\n"
      "  delos select scenes/12-ceiling-anchors.yaml --set selection.count=20 --json\n"
      "  delos select scenes/12-ceiling-anchors.yaml --out chosen.yaml --out "
      "chosen.png\n"
      "  delos optimize chosen.yaml                   then move what was chosen");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
