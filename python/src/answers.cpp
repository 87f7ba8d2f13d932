#include "answers.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "delos/text/units.h"
#include "options.h"
#include "scene.h"
#include "session/check_answer.h"
#include "session/comparison.h"
#include "session/named.h"
#include "session/point_answer.h"
#include "session/refusal.h"
#include "session/simulation_answer.h"
#include "stoppable.h"
#include "values.h"

namespace delos::python {
namespace {

using session::Blame;
using session::Refusal;

/// The target's orientation: what was asked for, or the scene's first.
Eigen::Vector3d orientation(const py::object& rpy, const Scene& scene) {
  if (!rpy.is_none()) return three(rpy, "rpy");
  const auto& turns = scene.orientations.rpy;
  return turns.empty() ? Eigen::Vector3d::Zero().eval() : turns.front();
}

py::object point(const py::object& scene, const py::object& at, const py::object& rpy,
                 const std::string& solver) {
  const SceneHold hold = scene_of(scene);
  const Eigen::Vector3d where = three(at, "at"),
                        turned = orientation(rpy, hold->loaded.scene);
  const Solver chosen = session::solver_named(solver);
  return to_python(stoppable(py::none(), [&](Watch&) {
    return session::point_json(
        session::answer_point(hold->loaded, where, turned, chosen), hold->loaded);
  }));
}

std::optional<Spec> better_spec(const std::string& limit, const Metric& metric) {
  if (limit.empty()) return std::nullopt;
  const auto value = parse_quantity(limit, metric.unit);
  if (const auto* problem = std::get_if<std::string>(&value))
    throw Refusal(Blame::question, "better_than '" + limit + "': " + *problem);
  return Spec{"", metric, metric.larger_is_better ? Relation::above : Relation::below,
              std::get<double>(value)};
}

py::object compare(const std::vector<py::object>& scenes,
                   const std::vector<std::string>& specs,
                   const std::string& better_than, int threads,
                   const py::object& progress) {
  if (scenes.size() < 2)
    throw Refusal(Blame::question, "a comparison needs two scenes or more");
  std::vector<session::LoadedScene> sides;
  std::vector<std::string> names;
  for (const py::object& scene : scenes) {
    sides.push_back(scene_of(scene)->loaded);
    names.push_back("scene " + std::to_string(names.size() + 1));
  }
  session::evaluate_alike(sides);
  if (const std::string no = session::incomparable(sides, names); !no.empty())
    throw Refusal(Blame::question, no);
  const session::ComparisonQuestion question{
      better_spec(better_than, sides.front().metric), specs};
  return to_python(stoppable(progress, [&](Watch& watch) {
    return session::comparison_json(session::compare_scenes(
        sides, question, field_options(watch, threads, "auto")));
  }));
}

py::object check(const std::filesystem::path& file, const py::dict& set) {
  const std::vector<Override> changes = overrides_of(set);
  return to_python(stoppable(py::none(), [&](Watch&) {
    return session::check_json(
        session::check_scene(file, changes, plugins(), Solver::automatic));
  }));
}

py::object simulate(const py::object& scene, const py::object& at,
                    const py::object& rpy, int runs, std::uint64_t seed,
                    const std::string& filter, double seconds, int threads,
                    const py::object& progress) {
  if (runs < 2) throw Refusal(Blame::question, "runs must be 2 or more");
  const SceneHold hold = scene_of(scene);
  const Eigen::Vector3d turned = orientation(rpy, hold->loaded.scene);
  const session::SimulatedPlace place{
      "", {rotation_from_rpy(turned), three(at, "at")}, turned};
  SimulationOptions options;
  options.filter = session::filter_named(filter);
  options.runs = runs;
  options.seed = seed;
  options.seconds = seconds;
  options.threads = threads;
  return to_python(stoppable(progress, [&](Watch& watch) {
    options.cancel = &watch.cancel;
    options.progress = [&watch](std::size_t done, std::size_t of) {
      watch.tell({done, of, std::nullopt});
    };
    const session::SimulationAnswer answer =
        session::answer_simulation(hold->loaded, place, options, plugins());
    if (!answer.simulation) throw Refusal(Blame::scene, answer.problem);
    return session::simulation_json({answer}, hold->loaded, options);
  }));
}

}  // namespace

void bind_answers(py::module_& module) {
  module.def(
      "point", point, py::arg("scene"), py::arg("at"), py::kw_only(),
      py::arg("rpy") = py::none(), py::arg("solver") = "auto",
      "All that can be said of a point: the document of `delos point --json`.\n\n"
      "at: metres; rpy: radians, or the scene's first orientation.");
  module.def("compare", compare, py::arg("scenes"), py::kw_only(),
             py::arg("specs") = std::vector<std::string>(), py::arg("better_than") = "",
             py::arg("threads") = 0, py::arg("progress") = py::none(),
             "Scenes side by side on the samples of the first, under one fusion: the "
             "document of `delos compare --json`.");
  module.def("check", check, py::arg("file"), py::kw_only(),
             py::arg("set") = py::dict(),
             "Whether a scene file is in order: one of `delos check --json`. Findings "
             "are in it, nothing is raised.");
  module.def("simulate", simulate, py::arg("scene"), py::arg("at"), py::kw_only(),
             py::arg("rpy") = py::none(), py::arg("runs") = 1000, py::arg("seed") = 1,
             py::arg("filter") = "extended", py::arg("seconds") = 0.0,
             py::arg("threads") = 0, py::arg("progress") = py::none(),
             "Filters on simulated readings beside what is predicted at a place: the "
             "document of `delos simulate --json`.\n\n"
             "seconds: how long a run is; 0: five time constants of the filter.");
}

}  // namespace delos::python
