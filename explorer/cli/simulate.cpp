// delos simulate: filters on simulated readings beside what is predicted.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "command.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "delos/text/words.h"
#include "evaluation.h"
#include "figures/simulation_chart.h"
#include "json.h"
#include "session/joined_crew.h"
#include "session/kept_simulation.h"
#include "session/named.h"
#include "session/simulation_answer.h"
#include "session/written_field.h"
#include "summary.h"

namespace delos::cli {
namespace {

using session::SimulatedPlace;
using session::SimulationAnswer;

struct SimulateCommand {
  SceneOptions options;
  std::filesystem::path scene, path, out, keep;
  std::vector<std::string> at;
  std::string rpy, filter = "extended", seconds;
  int runs = 1000;
  std::uint64_t seed = 1;
};

void check_out(const SimulateCommand& command, std::size_t places) {
  if (command.out.empty()) return;
  if (command.out.extension() != ".csv" && command.out.extension() != ".svg")
    throw Failure{kUsage, "--out '" + command.out.string() +
                              "': its name ends with .csv, the instants as rows, or "
                              ".svg, a picture of the error"};
  if (places != 1)
    throw Failure{kUsage,
                  "--out writes what happens at one place: give one --at, or --path"};
}

/// Go on from the runs that a file has, and keep more of them there.
void keep_runs(const SimulateCommand& command, const LoadedScene& loaded,
               const std::vector<SimulatedPlace>& all, SimulationOptions& options) {
  if (command.keep.empty()) return;
  if (all.size() != 1)
    throw Failure{kUsage, "--keep is of one place: give one --at, or --path"};
  const std::string identity = session::identity_of_runs(loaded, all.front(), options);
  session::KeptRuns kept = session::kept_runs(command.keep, identity);
  if (!kept.problem.empty()) throw Failure{kDiagnostics, kept.problem};
  options.resume = std::move(kept.sums);
  options.save = [file = command.keep, identity,
                  failed = false](const std::string& sums) mutable {
    if (failed) return;
    const std::string problem = session::save_runs(file, identity, sums);
    failed = !problem.empty();
    if (failed) std::cerr << "delos: runs aren't kept: " << problem << "\n";
  };
}

/// The target's orientation: what was asked for, or the scene's first.
Eigen::Vector3d orientation(const SimulateCommand& command, const Scene& scene) {
  if (!command.rpy.empty()) return three_numbers(command.rpy, "rad", "--rpy");
  const auto& turns = scene.orientations.rpy;
  return turns.empty() ? Eigen::Vector3d::Zero().eval() : turns.front();
}

std::vector<SimulatedPlace> places(const SimulateCommand& command,
                                   const LoadedScene& loaded,
                                   const SimulationOptions& options,
                                   const Interrupt& interrupt) {
  const Eigen::Vector3d rpy = orientation(command, loaded.scene);
  const auto at = [&](const Eigen::Vector3d& p) {
    return SimulatedPlace{"", {rotation_from_rpy(rpy), p}, rpy};
  };
  if (options.path) return {at(options.path->p.front())};
  std::vector<SimulatedPlace> all;
  for (const std::string& text : command.at)
    all.push_back(at(three_numbers(text, "m", "--at")));
  if (!all.empty()) return all;
  const Evaluation field = evaluate_scene(loaded, command.options, interrupt);
  all = session::typical_places(field.field, rpy);
  if (all.empty())
    throw Failure{kDiagnostics,
                  "no sample of the scene has a finite P∞ to hold filters against"};
  return all;
}

void print_consistency(std::ostream& out, const char* name, const Consistency& of,
                       double share) {
  out << "  " << name << " " << std::setprecision(4) << of.mean << ", expected "
      << of.expected << ", 95 % band " << of.lower << " to " << of.upper << ": "
      << (of.inside() ? "inside" : "outside") << "; " << percent(share)
      << " of the instants inside\n";
}

/// Means over a given path, which no band is of: the target doesn't move by the motion.
void print_along(std::ostream& out, const session::AlongPath& path,
                 const StateLayout& layout) {
  const auto names = layout.names(), units = layout.units();
  out << "  " << cell("along the path", 16) << cell("predicted", 14)
      << cell("measured", 14) << cell("filter's own", 14) << "measured/predicted\n";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    out << "    " << cell(names[i], 14)
        << cell(format_quantity(path.predicted(k), units[i]), 14)
        << cell(format_quantity(path.measured(k), units[i]), 14)
        << cell(format_quantity(path.filter(k), units[i]), 14) << std::setprecision(3)
        << path.measured(k) / path.predicted(k) << "\n";
  }
  if (path.blind > 0)
    out << "    " << path.blind << " instants without a finite P∞ are left out\n";
}

void print(std::ostream& out, const SimulationAnswer& answer,
           const LoadedScene& loaded) {
  const Eigen::Vector3d& p = answer.place.pose.p;
  out << (answer.place.name.empty() ? "" : answer.place.name + " place, ") << "at ("
      << p.x() << ", " << p.y() << ", " << p.z() << ") m";
  if (!answer.simulation) {
    out << ": " << answer.problem << "\n";
    return;
  }
  const Simulation& s = *answer.simulation;
  out << ", " << s.runs << " runs\n";
  if (s.lost > 0)
    out << "  lost: " << s.lost
        << " of them end more than 10 σ of P∞ off, and are in no other number\n";
  if (s.covariances.empty()) return;
  const auto names = loaded.system.motion.layout.names();
  const auto units = loaded.system.motion.layout.units();
  const bool along = s.instants.front().predicted.size() > 0;
  if (const auto path = session::along_path(s))
    print_along(out, *path, loaded.system.motion.layout);
  for (const SimulatedCovariance& c : s.covariances) {
    if (along) break;
    const StateVector predicted = session::deviations(c.predicted),
                      measured = session::deviations(c.measured),
                      errors = session::deviation_errors(c);
    out << "  " << cell(c.name, 16) << cell("predicted", 14) << cell("measured", 14)
        << "measured/predicted\n";
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      std::ostringstream ratio;
      ratio << std::setprecision(4) << measured(k) / predicted(k) << " ± "
            << std::setprecision(2) << errors(k) / predicted(k);
      out << "    " << cell(names[i], 14)
          << cell(format_quantity(predicted(k), units[i]), 14)
          << cell(format_quantity(measured(k), units[i]), 14) << ratio.str() << "\n";
    }
  }
  if (!along) {
    print_consistency(out, "NEES", s.instants.back().nees, s.nees_inside);
    print_consistency(out, "NIS ", s.instants.back().nis, s.nis_inside);
  }
  if (s.settles && s.settled_after)
    out << "  settled after " << format_quantity(*s.settled_after, "s")
        << "; time constant " << format_quantity(s.time_constant, "s") << "\n";
  else if (s.settles)
    out << "  never within 10 % of P∞ for good\n";
  if (s.coasting > 0)
    out << "  coasted: " << s.coasting
        << " runs had no reading for longer than a cycle, at most "
        << format_quantity(s.longest_gap, "s") << "\n";
  if (s.dropped > 0)
    out << "  " << s.dropped << " readings were of what the estimate had out of view\n";
}

/// What a path has that its scene doesn't sample.
void warn_of_leaving(const GivenPath& path, const LoadedScene& loaded) {
  const Samples samples = planned_samples(loaded.scene);
  if (samples.points.empty()) return;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : samples.points) box.extend(p);
  const auto outside = std::count_if(
      path.p.begin(), path.p.end(),
      [&](const Eigen::Vector3d& p) { return box.exteriorDistance(p) > 1e-9; });
  if (outside > 0)
    std::cerr << "delos: " << outside << " of the path's " << path.p.size()
              << " points lie outside the box that the scene samples\n";
}

void write_out(const SimulateCommand& command, const SimulationAnswer& answer,
               const LoadedScene& loaded) {
  if (command.out.empty() || !answer.simulation) return;
  if (answer.simulation->instants.empty()) return;  // stopped before two runs
  const std::string text =
      command.out.extension() == ".csv"
          ? session::instants_csv(*answer.simulation, loaded)
          : figures::simulation_chart(*answer.simulation, loaded.system.motion.layout);
  if (const std::string problem = write_text(command.out, text); !problem.empty())
    throw Failure{kDiagnostics, problem};
}

SimulationAnswer answered(const LoadedScene& loaded, const SimulatedPlace& place,
                          const SimulationOptions& options, PluginRegistry& plugins,
                          Crew* crew) {
  try {
    return session::answer_simulation(loaded, place, options, plugins, crew);
  } catch (const std::runtime_error& failure) {
    if (!crew) throw;
    throw Failure{kDiagnostics, failure.what()};
  }
}

int run(const SimulateCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const session::JoinedCrew crew(command.options.threads);
  if (crew.served(plugins)) return kDone;
  SimulationOptions options;
  options.filter = read_option([&] { return session::filter_named(command.filter); });
  const LoadedScene loaded = load(command.scene, command.options, plugins);
  options.runs = command.runs;
  options.seed = command.seed;
  options.threads = crew.threads();
  if (!command.seconds.empty()) {
    const auto value = parse_quantity(command.seconds, "s");
    if (const auto* problem = std::get_if<std::string>(&value))
      throw Failure{kUsage, "--seconds '" + command.seconds + "': " + *problem};
    options.seconds = std::get<double>(value);
    if (!(options.seconds > 0)) throw Failure{kUsage, "--seconds must be above 0"};
  }
  if (!command.path.empty()) {
    if (!command.at.empty())
      throw Failure{kUsage, "--path says where the target is; leave --at out"};
    Diagnostics diagnostics;
    const auto path = load_path(command.path, diagnostics);
    for (const Diagnostic& d : diagnostics) std::cerr << to_string(d) << "\n";
    if (!path) throw Failure{kDiagnostics, ""};
    options.path = session::given_path(*path);
    warn_of_leaving(*options.path, loaded);
  }
  const Interrupt interrupt;
  options.cancel = &interrupt.requested();
  const std::vector<SimulatedPlace> all = places(command, loaded, options, interrupt);
  check_out(command, all.size());
  keep_runs(command, loaded, all, options);
  std::vector<SimulationAnswer> answers;
  bool cancelled = false, refused = true;
  for (const SimulatedPlace& place : all) {
    Progress progress(loaded.scene.name +
                      (place.name.empty() ? "" : ", " + place.name + " place"));
    options.progress = [&](std::size_t done, std::size_t of) {
      progress.update(done, of);
    };
    answers.push_back(answered(loaded, place, options, plugins, crew.get()));
    const SimulationAnswer& answer = answers.back();
    refused = refused && !answer.simulation;
    cancelled = cancelled || (answer.simulation && answer.simulation->cancelled);
    write_out(command, answer, loaded);
  }
  if (refused) throw Failure{kDiagnostics, answers.front().problem};
  if (command.options.json) {
    print_document(session::simulation_json(answers, loaded, options));
  } else {
    std::cout << loaded.scene.name << ": " << command.filter << " filter, "
              << to_string(Definition{loaded.system.fusion, loaded.system.covariance})
              << ", seed " << command.seed << "\n";
    for (const SimulationAnswer& answer : answers) print(std::cout, answer, loaded);
  }
  return cancelled ? kCancelled : kDone;
}

}  // namespace

void add_simulate_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<SimulateCommand>();
  CLI::App* app =
      program.add_subcommand("simulate", "Simulated filters beside what is predicted");
  app->add_option("scene", command->scene, "Scene file")->required();
  app->add_option("--at", command->at,
                  "Position X,Y,Z, repeatable; without it the best, median and worst "
                  "place of the field")
      ->allow_extra_args(false);
  app->add_option("--rpy", command->rpy,
                  "Orientation R,P,Y; without it the scene's first");
  app->add_option("--path", command->path,
                  "Rows t,x,y,z in seconds and metres (.csv): the target is there");
  app->add_option("--runs", command->runs, "Runs at every place")
      ->check(CLI::Range(2, 100000000))
      ->capture_default_str();
  app->add_option("--seed", command->seed, "Of the random numbers")
      ->capture_default_str();
  app->add_option("--seconds", command->seconds,
                  "How long a run is; without it five time constants of the filter");
  app->add_option("--filter", command->filter,
                  "extended, iterated, sequential or unscented")
      ->capture_default_str();
  app->add_option("--out", command->out,
                  "Write the instants as rows (.csv) or a picture of the error (.svg)");
  app->add_option("--keep", command->keep,
                  "Keep finished runs in this file, and go on from it");
  add_scene_options(*app, command->options);
  app->footer(
      "Examples:\n"
      "  delos simulate scenes/01-acoustic.yaml --runs 2000 --seed 1 --json\n"
      "  delos simulate scenes/01-acoustic.yaml --at 0.2,0.2,0.4 --runs 100000 "
      "--keep runs.bin\n"
      "  delos simulate scenes/05-optitrack-lab.yaml --at 0,0,1.5 --filter unscented\n"
      "  mpirun -n 8 delos simulate scenes/01-acoustic.yaml --runs 100000\n"
      "  delos simulate scenes/05-optitrack-lab.yaml --path scenes/data/walk/walk.csv "
      "\\\n"
      "    --out walk.svg");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
