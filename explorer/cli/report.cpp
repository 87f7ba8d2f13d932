// delos report: a scene or a study as one HTML page.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <set>

#include "command.h"
#include "consensus.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "evaluation.h"
#include "report/installers_sheet.h"
#include "report/pages.h"
#include "report/tradeoff_section.h"
#include "report/words.h"
#include "search_report.h"
#include "session/search_answer.h"
#include "session/written_field.h"

namespace delos::cli {
namespace {

struct ReportCommand {
  SceneOptions options;
  std::filesystem::path input, out;
  std::string loss = "5 %";
  bool brief = false;
  std::vector<std::filesystem::path> tradeoffs;
};

/// Studies are SQLite databases, which begin with these bytes.
bool is_study(const std::filesystem::path& file) {
  constexpr std::string_view kMagic = "SQLite format 3";
  std::string start(kMagic.size(), ' ');
  std::ifstream(file, std::ios::binary)
      .read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == kMagic;
}

void stop_if(const Interrupt& interrupt) {
  if (interrupt.requested()) throw Failure{kCancelled, "stopped; nothing was written"};
}

/// The field, and what its maps are cut from: itself, or planes of an octree.
struct Shown {
  Field field;
  std::vector<report::View> views;
};

/// @param samples where; empty: the scene's own
Shown shown(const LoadedScene& loaded, const Field* same_samples,
            const SceneOptions& options, const Interrupt& interrupt) {
  Shown all;
  if (same_samples) {
    all.field = evaluate(loaded, same_samples->samples, options, interrupt);
    all.field.weight = same_samples->weight;
  } else {
    all.field = evaluate_scene(loaded, options, interrupt).field;
  }
  stop_if(interrupt);
  const bool larger = loaded.metric.larger_is_better;
  for (const Samples& plane : session::level_planes(loaded.scene)) {
    all.views.push_back(
        report::view_of(evaluate(loaded, plane, options, interrupt), larger));
    stop_if(interrupt);
  }
  if (all.views.empty()) all.views.push_back(report::view_of(all.field, larger));
  return all;
}

std::vector<report::PluginVersion> plugin_versions(const Scene& scene,
                                                   PluginRegistry& plugins) {
  std::set<std::string> types;
  for (const DeviceEntry& device : scene.devices) types.insert(device.type);
  std::vector<report::PluginVersion> all;
  for (const std::string& type : types)
    all.push_back({type, plugins.find(type).info->version});
  return all;
}

/// Which part of the samples outside solids each device sees, in any orientation.
std::vector<double> seen_parts(const LoadedScene& loaded, const Field& field) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < field.value.size(); ++i)
    if (field.inside.empty() || !field.inside[i])
      points.push_back(field.samples.points[i]);
  const auto seen = seen_points(loaded.system, loaded.scene.orientations, points);
  std::vector<double> parts;
  for (const std::vector<bool>& device : seen)
    parts.push_back(
        static_cast<double>(std::count(device.begin(), device.end(), true)) /
        static_cast<double>(std::max<std::size_t>(points.size(), 1)));
  return parts;
}

/// What is lost where a device is taken away.
void fail(report::DeviceRow& row, const Field& whole, const Field& without) {
  double before = 0, after = 0, weights = 0;
  bool defined = false;
  for (std::size_t i = 0; i < whole.value.size(); ++i) {
    if (!whole.inside.empty() && whole.inside[i]) continue;
    row.lost += whole.observable[i] && !without.observable[i];
    defined = defined || std::isfinite(whole.value[i]);
    if (!std::isfinite(whole.value[i]) || !std::isfinite(without.value[i])) continue;
    const double weight = whole.weight.empty() ? 1 : whole.weight[i];
    before += weight * whole.value[i];
    after += weight * without.value[i];
    weights += weight;
  }
  row.mean_rise = !defined ? std::numeric_limits<double>::quiet_NaN()
                  : weights > 0 && before != 0
                      ? (after - before) / std::abs(before)
                      : std::numeric_limits<double>::infinity();
}

std::vector<report::DeviceRow> device_rows(const LoadedScene& loaded,
                                           const Field& field,
                                           const SceneOptions& options,
                                           const Interrupt& interrupt) {
  const std::vector<double> parts = seen_parts(loaded, field);
  std::vector<report::DeviceRow> rows;
  for (std::size_t i = 0; i < loaded.system.devices.size(); ++i) {
    const PlacedDevice& device = loaded.system.devices[i];
    const TargetMount* carried = device.carried();
    const Eigen::Vector3d& at = carried ? carried->X_TS.p : device.X_WS().p;
    report::DeviceRow row{device.name, device.type, at, carried != nullptr,
                          parts[i],    0,           0};
    LoadedScene rest = loaded;
    rest.scene.name += " without " + device.name;
    rest.system.devices.erase(rest.system.devices.begin() +
                              static_cast<std::ptrdiff_t>(i));
    fail(row, field, evaluate(rest, field.samples, options, interrupt));
    stop_if(interrupt);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string scene_report(const ReportCommand& command, PluginRegistry& plugins,
                         const Interrupt& interrupt) {
  const LoadedScene loaded = load(command.input, command.options, plugins);
  report::SceneReport r;
  Shown all = shown(loaded, nullptr, command.options, interrupt);
  r.file = command.input.string();
  r.scene = loaded.scene;
  r.larger_is_better = loaded.metric.larger_is_better;
  r.devices = device_rows(loaded, all.field, command.options, interrupt);
  r.blind = blind_regions(loaded.system, loaded.scene.orientations, all.field);
  r.installation = report::installers_sheet(loaded.scene, loaded.system);
  r.markers = markers_of(loaded.scene, loaded.system);
  r.plugins = plugin_versions(loaded.scene, plugins);
  r.version = DELOS_VERSION;
  r.field = std::move(all.field);
  r.views = std::move(all.views);
  return report::scene_page(r);
}

/// The scene as it was given, judged as the last one is.
Scene judged_alike(Scene given, const Scene& last) {
  given.samples = last.samples;
  given.orientations = last.orientations;
  given.metric = last.metric;
  given.covariance = last.covariance;
  given.objective = last.objective;
  given.constraints = last.constraints;
  given.regions = last.regions;
  given.variables = last.variables;
  return given;
}

void add_design(report::StudyReport& r, PluginRegistry& plugins) {
  const auto number = [&](Scene& scene, const std::string& path) {
    return std::get<SceneNumber>(find_number(scene, path, plugins));
  };
  for (const VariableEntry& v : r.after.variables) {
    const SceneNumber was = number(r.before, v.path), is = number(r.after, v.path);
    const auto& locked = r.summary.locked;
    r.variables.push_back(
        {v.path, is.unit, *was.value, *is.value, v.lower, v.upper,
         std::find(locked.begin(), locked.end(), v.path) != locked.end()});
  }
}

/// Objective before and after, and how constraints are kept, on all samples.
void add_scores(report::StudyReport& r, const SceneOptions& options,
                PluginRegistry& plugins) {
  Problem before(r.before, plugins, {0, options.threads}),
      after(r.after, plugins, {0, options.threads});
  const Score best = after.score(after.design().start());
  const auto objective = [&](const Score& score) {
    return objective_shown(r.after, score.objective);
  };
  r.objective_before = objective(before.score(before.design().start()));
  r.objective_after = objective(best);
  const auto reports = constraint_reports(after, best);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const ConstraintEntry& entry = r.after.constraints[i];
    r.constraints.push_back({reports[i], report::constraint_words(entry, r.after),
                             constraint_unit(entry, r.after)});
  }
}

void add_answers(report::StudyReport& r, const ReportCommand& command,
                 PluginRegistry& plugins, const Interrupt& interrupt) {
  const auto loss = parse_quantity(command.loss, "1");
  if (const auto* problem = std::get_if<std::string>(&loss))
    throw Failure{kUsage, "--loss '" + command.loss + "': " + *problem};
  if (command.brief) return;
  Problem problem(r.after, plugins, {kAnswerSamples, command.options.threads});
  Progress progress(r.summary.scene + ", what the design depends on");
  r.answers = answers(
      problem, problem.design().start(), std::get<double>(loss), &interrupt.requested(),
      [&](std::size_t done, std::size_t of) { progress.update(done, of); });
  stop_if(interrupt);
}

/// What the starts of the last round agree on; nothing before one has found a design.
report::Html consensus_part(const report::StudyReport& r, const Study& study,
                            PluginRegistry& plugins) {
  constexpr std::size_t kMost = 10;
  if (session::best_of_starts(study, -1).empty()) return {};
  const session::StudyConsensus found =
      session::study_consensus(study, plugins, -1, kMost);
  std::vector<std::string> values;
  for (const ConsensusLayout& layout : found.consensus.layouts)
    values.push_back(
        format_quantity(objective_shown(r.after, layout.objective), r.objective_unit));
  return report::consensus_section(found.consensus, found.starts, values);
}

/// What delos tradeoff found.
report::Html tradeoff_parts(const std::vector<std::filesystem::path>& files) {
  report::Html all;
  for (const std::filesystem::path& file : files) {
    std::ifstream in(file);
    if (!in) throw Failure{kUsage, file.string() + ": can't be read"};
    try {
      all += report::tradeoff_section(Json::parse(in));
    } catch (const Json::parse_error&) {
      throw Failure{kDiagnostics, file.string() + ": isn't JSON"};
    } catch (const std::invalid_argument& refusal) {
      throw Failure{kDiagnostics, file.string() + ": " + refusal.what()};
    }
  }
  return all;
}

std::string study_report(const ReportCommand& command, PluginRegistry& plugins,
                         const Interrupt& interrupt) {
  const Study study(command.input, plugins);
  report::StudyReport r;
  r.file = command.input.string();
  r.summary = study.summary();
  r.after = study.scene();
  r.before = judged_alike(study.scene(0), r.after);
  const Scene* both[] = {&r.before, &r.after};
  if (const auto fusion = common_fusion(both))
    r.before.fusion = r.after.fusion = *fusion;
  r.objective = objective_text(r.after);
  r.objective_unit = objective_unit(r.after);
  r.maximize = objective_shown(r.after, 1) < 0;
  r.version = DELOS_VERSION;
  r.plugins = plugin_versions(r.after, plugins);
  for (const StudyRound& round : r.summary.rounds)
    r.evaluations.push_back(study.evaluations(round.number));
  add_design(r, plugins);

  const LoadedScene before = session::loaded_from(r.before, plugins),
                    after = session::loaded_from(r.after, plugins);
  Shown was = shown(before, nullptr, command.options, interrupt);
  Shown is = shown(after, &was.field, command.options, interrupt);
  r.larger_is_better = after.metric.larger_is_better;
  r.were = markers_of(before.scene, before.system);
  r.are = markers_of(after.scene, after.system);
  r.field_before = std::move(was.field);
  r.field_after = std::move(is.field);
  r.views_before = std::move(was.views);
  r.views_after = std::move(is.views);
  add_scores(r, command.options, plugins);
  r.more = report::section("To install it",
                           report::installers_sheet(after.scene, after.system)) +
           consensus_part(r, study, plugins) + tradeoff_parts(command.tradeoffs);
  add_answers(r, command, plugins, interrupt);
  return report::study_page(r);
}

int run(const ReportCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const Interrupt interrupt;
  std::string page;
  try {
    page = is_study(command.input) ? study_report(command, plugins, interrupt)
                                   : scene_report(command, plugins, interrupt);
  } catch (const std::invalid_argument& refusal) {
    throw Failure{kDiagnostics, refusal.what()};
  } catch (const std::runtime_error& failure) {
    throw Failure{kDiagnostics, failure.what()};
  }
  if (const std::string problem = write_text(command.out, page); !problem.empty())
    throw Failure{kDiagnostics, problem};
  std::cerr << "wrote " << command.out.string() << "\n";
  return kDone;
}

}  // namespace

void add_report_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<ReportCommand>();
  CLI::App* app = program.add_subcommand(
      "report", "A scene or a study as one HTML page, with pictures");
  app->add_option("input", command->input, "Scene file (.yaml), or study")->required();
  app->add_option("-o,--out", command->out, "The page to write, .html")->required();
  app->add_option("--loss", command->loss,
                  "Of a study: loss for which the variables' tolerances are told")
      ->capture_default_str();
  app->add_flag("--brief", command->brief,
                "Of a study: without tolerances and failures, which take longest");
  app->add_option("--tradeoff", command->tradeoffs,
                  "Of a study: also what delos tradeoff --json wrote; repeatable")
      ->allow_extra_args(false);
  app->add_option("--threads", command->options.threads, "Threads; 0: one a core")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  app->add_option("--metric", command->options.metric,
                  "Of a scene: metric instead of its own");
  app->add_option("--set", command->options.set,
                  "Of a scene: change a value: PATH=VALUE, repeatable")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  app->add_option("--plugin-dir", command->options.plugin_dirs,
                  "Folder with device plugins, searched first; repeatable")
      ->allow_extra_args(false);
  app->footer(
      "The page needs nothing else: no other files, no network and no scripts.\n"
      "Examples:\n"
      "  delos report scenes/06-furnished-lab.yaml -o lab.html\n"
      "  delos optimize scenes/09-camera-room.yaml --study room.study\n"
      "  delos report room.study -o room.html");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
