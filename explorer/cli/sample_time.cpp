// delos sample-time: how long should a device sample?
#include "session/sample_time.h"

#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "figures/chart.h"
#include "json.h"
#include "quantity.h"
#include "session/written_field.h"
#include "summary.h"

namespace delos::cli {
namespace {

using session::answer_sample_time;
using session::MotionTerm;
using session::sample_time_json;
using session::SampleTimeAnswer;
using session::SampleTimeQuestion;
using session::SampleTimeRow;

struct SampleTimeCommand {
  SceneOptions options;
  std::filesystem::path scene, out;
  std::string at, device, from, to, step, speed, motion = "exact";
  bool deviations = false;
};

constexpr std::pair<const char*, MotionTerm> kMotionTerms[] = {
    {"exact", MotionTerm::exact},       {"instantaneous", MotionTerm::instantaneous},
    {"averaged", MotionTerm::averaged}, {"integrated", MotionTerm::integrated},
    {"update", MotionTerm::update},     {"blur", MotionTerm::blur},
};

MotionTerm motion_named(const std::string& name) {
  for (const auto& [word, term] : kMotionTerms)
    if (name == word) return term;
  throw Failure{kUsage,
                "--motion '" + name +
                    "': choose exact, instantaneous, averaged, integrated, update or "
                    "blur"};
}

/// The times that are drawn.
/// @throws Failure kUsage; std::invalid_argument
std::vector<double> times_of(const SampleTimeCommand& command, const Scene& scene) {
  std::vector<double> times = session::usual_times(scene, command.device);
  const double from = command.from.empty()
                          ? times.front()
                          : quantity_above_0(command.from, "s", "--from");
  const double to =
      command.to.empty() ? times.back() : quantity_above_0(command.to, "s", "--to");
  if (!(to > from))
    throw Failure{kUsage, "--to must be above " + format_quantity(from, "s") +
                              ", from where the sample times are drawn"};
  if (command.step.empty()) {
    const double last = static_cast<double>(times.size() - 1);
    for (std::size_t i = 0; i < times.size(); ++i)
      times[i] = from * std::pow(to / from, static_cast<double>(i) / last);
    return times;
  }
  const double step = quantity_above_0(command.step, "s", "--step");
  const double count = std::floor((to - from) / step * (1 + 1e-12)) + 1;
  if (count < 3 || count > 10'000)
    throw Failure{kUsage,
                  "--step '" + command.step + "' must make 3 to 10,000 times of " +
                      format_quantity(from, "s") + " to " + format_quantity(to, "s")};
  times.resize(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < times.size(); ++i)
    times[i] = from + step * static_cast<double>(i);
  return times;
}

/// @throws Failure kUsage
std::vector<Eigen::Vector3d> points_of(const SampleTimeCommand& command,
                                       const Scene& scene) {
  if (!command.at.empty()) return {three_numbers(command.at, "m", "--at")};
  constexpr std::int64_t kMost = 10;
  std::int64_t count = 0;
  for (const SampleSet& set : scene.samples) count += sample_count(set);
  if (count == 0 || count > kMost)
    throw Failure{kUsage,
                  "say by --at X,Y,Z where; the scene has more than 10 samples"};
  return make_samples(scene.samples).points;
}

std::string row_name(const SampleTimeRow& row) {
  if (row.rows == 1) return row.device;
  const std::string name = row.device + ", row " + std::to_string(row.row + 1);
  return row.rows > 6
             ? name + " of " + std::to_string(row.rows) + ", which informs most"
             : name;
}

/// "1.2 ms (+3.4 %)": what a sample time costs in P∞.
std::string with_cost(double time, double value, const SampleTimeAnswer& answer,
                      const Metric& metric) {
  std::string text = format_quantity(time, "s", 4);
  if (!std::isfinite(value)) return text + ", where P∞ has no value";
  const double cost = 100 * (metric.larger_is_better ? answer.least / value - 1
                                                     : value / answer.least - 1);
  char percent[40];
  std::snprintf(percent, sizeof percent, ", %.3g %% worse in P∞", std::max(0.0, cost));
  return text + percent;
}

void print(std::ostream& out, const SampleTimeAnswer& answer,
           const LoadedScene& loaded) {
  const char* kind = answer.question.deviations ? "standard deviations" : "variances";
  out << loaded.scene.name << " at (" << answer.at.x() << ", " << answer.at.y() << ", "
      << answer.at.z() << ") m, " << session::to_string(answer.question.motion)
      << " motion, " << kind << " added\n";
  for (const SampleTimeRow& row : answer.rows) {
    out << row_name(row) << "\n"
        << "  least sum     " << std::setprecision(5) << row.least << " at "
        << with_cost(row.best, row.metric_at_best, answer, loaded.metric)
        << (row.at_end ? ", an end of the range" : "") << "\n"
        << "  least drawn   " << row.sum[row.best_drawn] << " at "
        << format_quantity(answer.question.times[row.best_drawn], "s", 4) << "\n"
        << "  crossover     "
        << (row.crossover ? with_cost(*row.crossover, *row.metric_at_crossover, answer,
                                      loaded.metric)
                          : std::string("none in the range"))
        << "\n";
  }
  out << loaded.metric.name << " of the " << to_string(definition_of(loaded.system))
      << ": best " << format_quantity(answer.least, loaded.metric.unit, 4) << " at "
      << format_quantity(answer.best, "s", 4)
      << (answer.at_end ? ", an end of the range" : "") << "\n"
      << "As the motion changes  best of P∞   least sum\n";
  for (const session::SampleTimeOfMotion& of : answer.of_motion)
    out << "  q times " << cell(shortest(of.factor), 13)
        << cell(format_quantity(of.best, "s"), 13) << format_quantity(of.rule, "s")
        << "\n";
}

figures::Series series(const std::string& name, const std::vector<double>& times,
                       const std::vector<double>& values) {
  constexpr std::size_t kFew = 30;
  figures::Series out{
      name, times.size() <= kFew ? figures::Stroke::line : figures::Stroke::curve, {}};
  for (std::size_t i = 0; i < times.size(); ++i)
    if (std::isfinite(values[i]) && values[i] > 0)
      out.points.push_back({times[i], values[i]});
  return out;
}

/// A page with the curves of every row, and that of P∞.
std::string page_of(const std::vector<SampleTimeAnswer>& answers,
                    const LoadedScene& loaded) {
  figures::Html body;
  for (const SampleTimeAnswer& answer : answers) {
    const std::vector<double>& times = answer.question.times;
    const std::string at = "(" + format_quantity(answer.at.x(), "m") + ", " +
                           format_quantity(answer.at.y(), "m") + ", " +
                           format_quantity(answer.at.z(), "m") + ")";
    for (const SampleTimeRow& row : answer.rows) {
      figures::Chart chart;
      chart.says = "noise, motion and their sum by the sample time of " + row.device;
      chart.x_name = "sample time";
      chart.x_unit = "s";
      chart.y_name = answer.question.deviations ? "standard deviation" : "variance";
      chart.series = {series("R", times, row.noise), series("HQHᵀ", times, row.motion),
                      series("sum", times, row.sum)};
      chart.marks.push_back({row.best, "least " + format_quantity(row.best, "s")});
      if (row.crossover)
        chart.marks.push_back(
            {*row.crossover, "crossover " + format_quantity(*row.crossover, "s")});
      body += figures::chart_figure(chart, row_name(row) + " at " + at);
    }
    figures::Chart chart;
    chart.says = "the metric of P∞ by the sample time";
    chart.x_name = "sample time";
    chart.x_unit = "s";
    chart.y_name = loaded.metric.name;
    chart.y_unit = loaded.metric.unit;
    chart.series = {series(loaded.metric.name + " of P∞", times, answer.metric)};
    if (chart.series[0].points.empty()) continue;
    chart.marks.push_back({answer.best, "best " + format_quantity(answer.best, "s")});
    body += figures::chart_figure(chart, "P∞ with all of them at " + at);
  }
  return figures::page(loaded.scene.name + ": sample times", body);
}

int run(const SampleTimeCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const LoadedScene loaded = load(command.scene, command.options, plugins);
  SampleTimeQuestion question;
  question.motion = motion_named(command.motion);
  question.deviations = command.deviations;
  question.device = command.device;
  const bool blur = question.motion == MotionTerm::blur;
  if (blur == command.speed.empty())
    throw Failure{kUsage, blur ? "--motion blur needs a --speed"
                               : "--speed goes with --motion blur"};
  if (blur) question.speed = quantity_above_0(command.speed, "m/s", "--speed");
  std::vector<SampleTimeAnswer> answers;
  try {
    question.times = times_of(command, loaded.scene);
    for (const Eigen::Vector3d& at : points_of(command, loaded.scene))
      answers.push_back(answer_sample_time(loaded, at, question, plugins));
  } catch (const std::invalid_argument& refusal) {
    throw Failure{kDiagnostics, refusal.what()};
  }
  if (command.options.json) {
    print_document(sample_time_json(answers, loaded));
  } else {
    for (const SampleTimeAnswer& answer : answers) print(std::cout, answer, loaded);
  }
  if (command.out.empty()) return kDone;
  const std::string problem = write_text(command.out, page_of(answers, loaded));
  if (!problem.empty()) throw Failure{kDiagnostics, problem};
  std::cerr << "wrote " << command.out.string() << "\n";
  return kDone;
}

}  // namespace

void add_sample_time_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<SampleTimeCommand>();
  CLI::App* app = program.add_subcommand(
      "sample-time", "How long to sample: noise against motion, and in P∞");
  app->add_option("scene", command->scene, "Scene file")->required();
  app->add_option("--at", command->at,
                  "Position X,Y,Z, metres or with units; default: the scene's samples, "
                  "where they are few");
  app->add_option("--device", command->device,
                  "The only device that changes; default: all with noise_over_time");
  app->add_option("--motion", command->motion,
                  "What counts against the noise: exact, instantaneous, averaged, "
                  "integrated, update or blur")
      ->capture_default_str();
  app->add_option("--speed", command->speed, "Of the target, for --motion blur, m/s");
  app->add_flag("--deviations", command->deviations,
                "Add standard deviations, as some of the published figures do");
  app->add_option("--from", command->from, "The least sample time");
  app->add_option("--to", command->to, "The greatest");
  app->add_option("--step", command->step,
                  "Times a step apart; default: a hundred in equal proportions");
  app->add_option("-o,--out", command->out, "A page with the curves, .html");
  add_scene_options(*app, command->options);
  app->footer(
      "Examples:\n"
      "  delos sample-time scenes/33-shutter-room.yaml --at 2,2,1 --out curves.html\n"
      "  delos sample-time scenes/31-photodiode-window.yaml --motion update\n"
      "      --deviations --from '21 us' --to '315 us' --step '21 us'");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
