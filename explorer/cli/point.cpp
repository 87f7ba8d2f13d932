// delos point: everything about one point.
#include "delos/field/point.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "command.h"
#include "delos/observe/beacon_use.h"
#include "delos/scene/definition.h"
#include "delos/text/format.h"
#include "json.h"
#include "lost_directions.h"
#include "one_more_device.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct PointCommand {
  SceneOptions options;
  std::filesystem::path scene;
  std::string at, rpy = "0,0,0";
};

/// Rows and columns of states that reach into a lost direction have no finite
/// covariance.
StateMatrix with_infinities(StateMatrix P, const StateMatrix& unobservable) {
  if (unobservable.cols() == 0) return P;
  for (Eigen::Index i = 0; i < unobservable.rows(); ++i) {
    if (unobservable.row(i).cwiseAbs().maxCoeff() < 1e-9) continue;
    P.row(i).setConstant(std::numeric_limits<double>::infinity());
    P.col(i).setConstant(std::numeric_limits<double>::infinity());
  }
  return P;
}

/// What one more device would do; null: none of those tried would.
Json to_json(const Mending& mending, const Metric& metric) {
  if (!mending.best) return {};
  return {{"like", mending.best->like},           {"type", mending.best->type},
          {"at", numbers(mending.best->at)},      {"metric", metric.name},
          {"value", number(mending.best->value)}, {"unit", metric.unit}};
}

Json to_json(const PointReport& report, const std::optional<Mending>& mending,
             const LoadedScene& loaded, const Eigen::Vector3d& rpy) {
  const FusedState& state = report.state;
  const auto covariance = [&](const StateMatrix& P) {
    return rows(with_infinities(P, state.unobservable));
  };
  Json json;
  json["scene"] = loaded.scene.name;
  json["at"] = numbers(report.pose.p);
  json["rpy"] = numbers(rpy);
  json["fusion"] = to_string(loaded.system.fusion);
  json["solver"] = to_string(report.solver);
  json["covariance_of"] = to_string(state.of);
  json["state"] = loaded.system.motion.layout.names();
  json["units"] = loaded.system.motion.layout.units();
  json["inside"] = report.inside;
  json["observable"] = state.status == RiccatiStatus::converged;
  json["unobservable_directions"] = rows(state.unobservable.transpose());
  if (mending) json["one_more_device"] = to_json(*mending, loaded.metric);
  json["metrics"] = Json::object();
  for (const MetricValue& m : report.metrics) {
    json["metrics"][m.metric.name] = {{"value", number(m.value)},
                                      {"unit", m.metric.unit}};
  }
  // Before a single reading nothing is known.
  json["P_prior"] = loaded.system.covariance == CovarianceKind::single
                        ? Json()
                        : covariance(state.prior);
  json["P_posterior"] = covariance(state.posterior);
  if (state.worst_prior.size() > 0) {
    json["P_worst_prior"] = covariance(state.worst_prior);
    json["P_best_posterior"] = covariance(state.best_posterior);
  }
  json["residual"] = number(report.residual);
  json["devices"] = Json::array();
  for (const DeviceShare& d : report.devices) {
    json["devices"].push_back({{"name", d.name},
                               {"type", d.type},
                               {"visible", d.visible},
                               {"share", number(d.share)}});
  }
  const std::vector<SeenBeacon> seen = seen_beacons(loaded.system, report.pose);
  if (seen.empty()) return json;
  json["sightings"] = Json::array();
  for (const SeenBeacon& s : seen) {
    json["sightings"].push_back({{"device", s.device},
                                 {"view", s.view},
                                 {"beacon", numbers(s.at)},
                                 {"distance", number(s.distance)},
                                 {"share", number(s.share)}});
  }
  return json;
}

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

/// What is estimated besides the motion: clocks, biases.
void print_extra_states(std::ostream& out, const FusedState& state,
                        const System& system) {
  const StateLayout& layout = system.motion.layout;
  const std::vector<std::string> names = layout.names(), units = layout.units();
  const StateMatrix P =
      with_infinities(state.covariance(system.covariance), state.unobservable);
  for (auto i = static_cast<std::size_t>(layout.size()) - layout.extra.size();
       i < names.size(); ++i) {
    const double variance =
        P(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
    out << "  " << cell(names[i], 18)
        << (std::isfinite(variance) ? format_quantity(std::sqrt(variance), units[i])
                                    : std::string("not observed"))
        << "\n";
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

void print(std::ostream& out, const PointReport& report,
           const std::optional<Mending>& mending, const LoadedScene& loaded) {
  const FusedState& state = report.state;
  out << loaded.scene.name << " at (" << report.pose.p.x() << ", " << report.pose.p.y()
      << ", " << report.pose.p.z() << ") m: "
      << (state.status == RiccatiStatus::converged ? "every direction is observed"
          : state.status == RiccatiStatus::unobservable
              ? "some directions are not observed"
              : "the iteration did not settle")
      << "\n";
  if (report.inside) out << "  The point is inside a solid: fields leave it out.\n";
  for (const std::string& line : lost_directions(loaded.system, report))
    out << "  " << line << "\n";
  if (mending) out << "  " << words_of(*mending, loaded.metric) << "\n";
  out << to_string(Definition{loaded.system.fusion, loaded.system.covariance})
      << ", solver " << to_string(report.solver) << "\n";
  if (state.of != CovarianceOf::every_update)
    out << "P∞ is " << to_string(state.of) << "\n";
  for (const MetricValue& m : report.metrics) {
    // Most devices have no pixels.
    if (m.metric.kind == MetricKind::footprint && !std::isfinite(m.value)) continue;
    out << "  " << cell(m.metric.name, 18)
        << (std::isfinite(m.value) ? format_quantity(m.value, m.metric.unit)
                                   : std::string("not observed"))
        << "\n";
  }
  print_extra_states(out, state, loaded.system);
  print_shares(out, report, loaded.metric.name);
  const std::vector<SeenBeacon> seen = seen_beacons(loaded.system, report.pose);
  if (!seen.empty()) out << "Beacons in view\n";
  print_sightings(out, seen);
  for (const std::string& why : blind_devices(loaded.system, {report.pose})) {
    out << why << "\n";
  }
}

int run(const PointCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const LoadedScene loaded = load(command.scene, command.options, plugins);
  const Eigen::Vector3d at = three_numbers(command.at, "m", "--at");
  const Eigen::Vector3d rpy = three_numbers(command.rpy, "rad", "--rpy");
  const Solver solver = solver_named(command.options.solver);
  const auto [report, mending] = [&] {
    try {
      PointReport point = evaluate_point(loaded.system, {rotation_from_rpy(rpy), at},
                                         loaded.metric, solver);
      std::optional<Mending> more =
          mend_by_one_device(loaded.system, point, rpy, loaded.metric, solver);
      return std::pair(std::move(point), std::move(more));
    } catch (const std::invalid_argument& error) {
      throw unsolvable(command.options, error);
    }
  }();
  if (command.options.json) {
    print_document(to_json(report, mending, loaded, rpy));
  } else {
    print(std::cout, report, mending, loaded);
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
