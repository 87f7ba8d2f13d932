// delos point: everything about one point.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <utility>

#include "command.h"
#include "delos/text/format.h"
#include "json.h"
#include "session/named.h"
#include "session/point_answer.h"
#include "summary.h"

namespace delos::cli {
namespace {

using session::answer_point;
using session::lost_words;
using session::point_json;
using session::PointAnswer;

struct PointCommand {
  SceneOptions options;
  std::filesystem::path scene;
  std::string at, rpy = "0,0,0";
};

/// What devices on the target see, a line for each view that sees anything.
void print_sightings(std::ostream& out, const std::vector<SeenBeacon>& seen) {
  struct Line {
    std::size_t beacons = 0;
    double share = 0;
    double nearest = std::numeric_limits<double>::infinity();
  };
  std::vector<std::pair<std::string, Line>> lines;
  for (const SeenBeacon& s : seen) {
    const std::string name = s.device + ", " + s.view;
    if (lines.empty() || lines.back().first != name) lines.push_back({name, {}});
    Line& line = lines.back().second;
    ++line.beacons;
    line.share += s.share;
    line.nearest = std::min(line.nearest, s.distance);
  }
  for (const auto& [name, line] : lines) {
    out << "  " << cell(name, 44) << counted(line.beacons, "beacon") << " from "
        << format_quantity(line.nearest, "m") << ", " << std::setprecision(3)
        << line.share << " sightings an update\n";
  }
}

/// What each device is to the point.
void print_shares(std::ostream& out, const PointReport& report,
                  const std::string& metric) {
  const bool defined =
      std::none_of(report.devices.begin(), report.devices.end(),
                   [](const DeviceShare& d) { return std::isnan(d.share); });
  out << (defined ? "Without this device alone, " + metric + " rises by"
                  : metric + " isn't observed, with any device or without it")
      << "\n";
  for (const DeviceShare& d : report.devices) {
    out << "  " << cell(d.name, 18);
    if (!d.visible) {
      out << "(doesn't see the point)";
    } else if (std::isnan(d.share)) {
      out << "sees the point";
    } else if (!std::isfinite(d.share)) {
      out << "lost";
    } else {
      out << std::setprecision(3) << 100 * d.share << " %";
    }
    out << "\n";
  }
}

/// "12.3 mm"; of what isn't observed, so.
std::string value_text(double value, const std::string& unit) {
  return std::isfinite(value) ? format_quantity(value, unit) : "not observed";
}

/// Whether a metric says anything of an error, which has parts.
bool has_parts(MetricKind kind) {
  switch (kind) {
    case MetricKind::coverage:
    case MetricKind::footprint:
    case MetricKind::latency:
    case MetricKind::nonlinearity:
    case MetricKind::unscented_ratio:
      return false;
    default:
      return true;
  }
}

/// Every metric a line, with its parts where devices say how well they are known.
void print_metrics(std::ostream& out, const PointReport& report, ErrorPart part) {
  std::vector<std::vector<std::string>> lines;
  if (report.budget) lines.push_back({"", to_string(part), "scatter", "bias"});
  for (std::size_t m = 0; m < report.metrics.size(); ++m) {
    const auto& [metric, value] = report.metrics[m];
    // Most devices have no pixels.
    if (metric.kind == MetricKind::footprint && !std::isfinite(value)) continue;
    lines.push_back({metric.name, value_text(value, metric.unit)});
    if (!report.budget || !has_parts(metric.kind)) continue;
    const double bias = report.budget->bias[m];
    lines.back().push_back(value_text(report.budget->scatter[m], metric.unit));
    // Of no volume, it has no finite one.
    lines.back().push_back(std::isfinite(bias) ? value_text(bias, metric.unit) : "-");
  }
  std::vector<std::size_t> widths = {18, 0, 0, 0};
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = std::max(widths[i], line[i].size() + 2);
  for (const auto& line : lines) {
    out << "  ";
    for (std::size_t i = 0; i + 1 < line.size(); ++i) out << cell(line[i], widths[i]);
    out << line.back() << "\n";
  }
}

/// What better calibrations are worth, and how far plain least squares is off.
void print_budget(std::ostream& out, const PointReport& report, const Metric& metric) {
  if (!report.budget) return;
  const auto print_each = [&](const char* what, const auto& all) {
    if (std::none_of(all.begin(), all.end(),
                     [](const auto& one) { return one.calibration != 0; }))
      return;
    out << "Known exactly, this " << what << " alone would improve " << metric.name
        << " by\n";
    for (const auto& one : all)
      if (one.calibration != 0)
        out << "  " << cell(one.name, 18) << std::setprecision(3)
            << 100 * one.calibration << " %\n";
  };
  print_each("device", report.devices);
  print_each("common error", report.budget->common);
  if (const auto& plain = report.budget->plain)
    out << "Plain least squares of one reading: " << metric.name << " "
        << value_text(plain->total, metric.unit) << ", scatter "
        << value_text(plain->scatter, metric.unit) << " and bias "
        << value_text(plain->bias, metric.unit) << "\n";
}

void print(std::ostream& out, const PointAnswer& answer, const LoadedScene& loaded) {
  const PointReport& report = answer.report;
  const FusedState& state = report.state;
  out << loaded.scene.name << " at (" << report.pose.p.x() << ", " << report.pose.p.y()
      << ", " << report.pose.p.z() << ") m: "
      << (state.status == RiccatiStatus::converged ? "every direction is observed"
          : state.status == RiccatiStatus::unobservable
              ? "some directions are not observed"
              : "the iteration did not settle")
      << "\n";
  if (report.inside) out << "  The point is inside a solid: fields leave it out.\n";
  for (const std::string& line : lost_words(answer, loaded))
    out << "  " << line << "\n";
  out << to_string(definition_of(loaded.system)) << ", solver "
      << to_string(report.solver) << "\n";
  if (state.of != CovarianceOf::every_update)
    out << "P∞ is " << to_string(state.of) << "\n";
  print_metrics(out, report, loaded.system.error);
  print_shares(out, report, loaded.metric.name);
  print_budget(out, report, loaded.metric);
  if (!answer.sightings.empty()) out << "Beacons in view\n";
  print_sightings(out, answer.sightings);
  for (const std::string& why : blind_devices(loaded.system, {report.pose})) {
    out << why << "\n";
  }
}

int run(const PointCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const LoadedScene loaded = load(command.scene, command.options, plugins);
  const Eigen::Vector3d at = three_numbers(command.at, "m", "--at");
  const Eigen::Vector3d rpy = three_numbers(command.rpy, "rad", "--rpy");
  const Solver solver =
      read_option([&] { return session::solver_named(command.options.solver); });
  const PointAnswer answer = [&] {
    try {
      return answer_point(loaded, at, rpy, solver);
    } catch (const std::invalid_argument& error) {
      throw unsolvable(command.options, error);
    }
  }();
  if (command.options.json) {
    print_document(point_json(answer, loaded));
  } else {
    print(std::cout, answer, loaded);
  }
  return kDone;
}

}  // namespace

void add_point_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<PointCommand>();
  CLI::App* app = program.add_subcommand("point", "Everything about one point");
  app->add_option("scene", command->scene, "Scene file")->required();
  app->add_option("--at", command->at, "Position X,Y,Z, metres or with units")
      ->required();
  app->add_option("--rpy", command->rpy, "Orientation R,P,Y, radians or with units")
      ->capture_default_str();
  add_scene_options(*app, command->options);
  app->footer(
      "Examples:\n"
      "  delos point scenes/01-acoustic.yaml --at 0.2,0.2,0.4\n"
      "  delos point scenes/02-eight-cameras.yaml --at '20 cm,20 cm,24 cm' --json\n"
      "  delos point scenes/hiball/six-lepd.yaml --at 4.5,7.5,1.9");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
