#include "searches.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "delos/optimize/choices.h"
#include "delos/optimize/cover_scene.h"
#include "delos/optimize/study.h"
#include "scene.h"
#include "session/refusal.h"
#include "session/search_answer.h"
#include "session/select_answer.h"
#include "session/study_answer.h"
#include "session/tradeoff_answer.h"
#include "stoppable.h"
#include "values.h"

namespace delos::python {
namespace {

using session::Blame;
using session::Refusal;

/// What a search refuses in a sentence is about its scene.
template <class Search>
auto refusing(Search&& search) {
  try {
    return search();
  } catch (const std::invalid_argument& refusal) {
    throw Refusal(Blame::scene, refusal.what());
  }
}

/// What searches are given, but for their scene.
OptimizeOptions options_of(const std::string& algorithm, int starts, int evaluations,
                           std::uint64_t seed, std::size_t samples, int threads) {
  OptimizeOptions options;
  options.algorithm = algorithm;
  options.starts = starts;
  options.evaluations = evaluations;
  options.seed = seed;
  options.samples = samples;
  options.threads = threads;
  return options;
}

void watched(OptimizeOptions& options, Watch& watch) {
  options.cancel = &watch.cancel;
  options.progress = [&watch](const SearchProgress& at) {
    watch.tell({at.evaluations, at.of, at.best});
  };
}

/// A document with the scene that was found.
py::dict with_scene(const session::Json& json, Scene scene, const PythonScene& began) {
  py::dict answer = to_python(json);
  answer["best_scene"] = found_scene(std::move(scene), began);
  return answer;
}

py::dict optimize_scene(const py::object& scene, const std::string& algorithm,
                        int starts, int evaluations, std::uint64_t seed,
                        std::size_t samples, int threads,
                        const std::optional<std::filesystem::path>& study,
                        const py::object& progress) {
  const SceneHold hold = scene_of(scene);
  OptimizeOptions options =
      options_of(algorithm, starts, evaluations, seed, samples, threads);
  OptimizeResult result = stoppable(progress, [&](Watch& watch) {
    watched(options, watch);
    return refusing([&] {
      if (!study) return optimize(hold->loaded.scene, plugins(), options);
      return Study::create(
                 *study, hold->loaded.scene, hold->source.file.parent_path(),
                 {algorithm, evaluations, starts, seed, samples, DELOS_VERSION},
                 plugins())
          .run(options);
    });
  });
  const session::Json json = session::search_json(result, plugins());
  return with_scene(json, std::move(result.scene), *hold);
}

py::dict select_scene(const py::object& scene, double gap, double seconds,
                      std::size_t samples, std::uint64_t seed, int threads,
                      const py::object& progress) {
  const SceneHold hold = scene_of(scene);
  SelectOptions options;
  options.gap = gap;
  options.seconds = seconds;
  options.samples = samples;
  options.seed = seed;
  options.threads = threads;
  session::Json json;
  Scene chosen = stoppable(progress, [&](Watch& watch) {
    options.cancel = &watch.cancel;
    options.progress = [&watch](const SelectProgress& at) {
      watch.tell({at.nodes, 0, at.value});
    };
    return refusing([&] {
      if (hold->loaded.scene.selection.cover) {
        const SceneCover cover = cover_scene(hold->loaded.scene, plugins(), options);
        json = session::cover_json(cover);
        return chosen_scene(cover.all, cover.chosen);
      }
      const SelectResult found = select(hold->loaded.scene, plugins(), options);
      json = session::select_json(found);
      return chosen_scene(found.all, found.chosen);
    });
  });
  return with_scene(json, std::move(chosen), *hold);
}

py::object front(const py::object& scene, const std::string& constraint,
                 const std::vector<double>& levels, int starts, int evaluations,
                 std::uint64_t seed, std::size_t samples, int threads,
                 const py::object& progress) {
  const SceneHold hold = scene_of(scene);
  if (levels.empty()) throw Refusal(Blame::question, "levels: give one or more");
  OptimizeOptions options =
      options_of("auto", starts, evaluations, seed, samples, threads);
  return to_python(stoppable(progress, [&](Watch& watch) {
    options.cancel = &watch.cancel;
    return refusing([&] {
      const auto points =
          search_front(hold->loaded.scene, plugins(), constraint, levels, options,
                       [&](std::size_t done, std::size_t of) {
                         watch.tell({done, of, {}});
                       });
      return session::front_json(hold->loaded.scene, constraint, points, plugins());
    });
  }));
}

py::dict resume(Study& study, int threads, const py::object& progress) {
  OptimizeOptions options;
  options.threads = threads;
  const OptimizeResult result = stoppable(progress, [&](Watch& watch) {
    watched(options, watch);
    return refusing([&] { return study.run(options); });
  });
  return to_python(session::search_json(result, plugins()));
}

SceneHold scene_of_round(const Study& study, int round) {
  const PythonScene place{{study.folder() / "scene.yaml", std::nullopt, {}}, {}};
  return found_scene(refusing([&] { return study.scene(round); }), place);
}

void act(Study& study, const std::string& verb, const std::string& argument) {
  try {
    study.act(verb, argument);
  } catch (const std::invalid_argument& refusal) {
    throw Refusal(Blame::question, refusal.what());
  }
}

void bind_study(py::module_& module) {
  py::class_<Study>(module, "Study",
                    "A search that is kept in a file: interrupted, resumed, steered. "
                    "optimize(study=…) begins one.")
      .def(py::init([](const std::filesystem::path& file) {
             return Study(file, plugins());
           }),
           py::arg("file"))
      .def(
          "json",
          [](const Study& s) { return to_python(session::study_json(s.summary())); },
          "The document of `delos study --json`.")
      .def("scene", scene_of_round, py::arg("round") = -1,
           "The scene with a round's best values; -1: the last round's.")
      .def("act", act, py::arg("verb"), py::arg("argument") = "",
           "Steer it: lock, unlock, set, keep, drop, forbid, inject, extend, undo, as "
           "`delos study` does.")
      .def("resume", resume, py::kw_only(), py::arg("threads") = 0,
           py::arg("progress") = py::none(),
           "Go on: the document of `delos optimize --json`.")
      .def("dump", &Study::dump, "Everything in it as text.");
}

}  // namespace

void bind_searches(py::module_& module) {
  module.def("optimize", optimize_scene, py::arg("scene"), py::kw_only(),
             py::arg("algorithm") = "auto", py::arg("starts") = 0,
             py::arg("evaluations") = 0, py::arg("seed") = 1, py::arg("samples") = 1500,
             py::arg("threads") = 0, py::arg("study") = py::none(),
             py::arg("progress") = py::none(),
             "Search for better values of a scene's variables: the document of "
             "`delos optimize --json`, and `best_scene`.\n\n"
             "study: a new file that keeps the search. progress: called with (done, "
             "of, best).");
  module.def("select", select_scene, py::arg("scene"), py::kw_only(),
             py::arg("gap") = 0.01, py::arg("seconds") = 60.0,
             py::arg("samples") = 1500, py::arg("seed") = 1, py::arg("threads") = 0,
             py::arg("progress") = py::none(),
             "Choose among candidates, with a proof of how good the choice is: the "
             "document of `delos select --json`, and `best_scene`.");
  module.def("front", front, py::arg("scene"), py::arg("constraint"), py::arg("levels"),
             py::kw_only(), py::arg("starts") = 0, py::arg("evaluations") = 0,
             py::arg("seed") = 1, py::arg("samples") = 1500, py::arg("threads") = 0,
             py::arg("progress") = py::none(),
             "The best designs for many limits of a constraint: the document of `delos "
             "tradeoff --limit --json`.\n\n"
             "levels: SI.");
  bind_study(module);
}

}  // namespace delos::python
