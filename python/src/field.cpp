#include "field.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>

#include "options.h"
#include "scene.h"
#include "session/scene_field.h"
#include "session/specs.h"
#include "session/written_field.h"
#include "stoppable.h"
#include "values.h"

namespace delos::python {
namespace {

/// A field and what it is of.
struct PythonField {
  session::Evaluation evaluation;
  FieldStatistics statistics;
  SceneHold scene;

  [[nodiscard]] const Field& field() const { return evaluation.field; }
};

std::shared_ptr<PythonField> evaluate(const py::object& scene, int threads,
                                      const std::string& solver,
                                      const py::object& progress) {
  const SceneHold hold = scene_of(scene);
  return stoppable(progress, [&](Watch& watch) {
    auto all = std::make_shared<PythonField>();
    all->evaluation =
        session::evaluate_scene(hold->loaded, field_options(watch, threads, solver));
    all->statistics = summarize(all->field());
    all->scene = hold;
    return all;
  });
}

py::array values(const std::shared_ptr<PythonField>& f) {
  const auto& v = f->field().value;
  return view(v.data(), {static_cast<py::ssize_t>(v.size())}, py::cast(f));
}

py::array points(const std::shared_ptr<PythonField>& f) {
  const auto& p = f->field().samples.points;
  return view(p.empty() ? nullptr : p.front().data(),
              {static_cast<py::ssize_t>(p.size()), 3}, py::cast(f));
}

py::array flags(const std::vector<unsigned char>& all, const py::object& owner) {
  static_assert(sizeof(bool) == 1, "flags are read as booleans");
  return view(reinterpret_cast<const bool*>(all.data()),
              {static_cast<py::ssize_t>(all.size())}, owner);
}

void save_field(const PythonField& f, const std::filesystem::path& file, bool log10,
                std::optional<double> slice) {
  PictureOptions picture;
  picture.log10 = log10;
  picture.larger_is_better = f.field().larger_is_better;
  picture.devices = markers_of(f.scene->loaded.scene, f.scene->loaded.system);
  picture.has_slice = slice.has_value();
  picture.slice_z = slice.value_or(0);
  const std::string problem =
      session::write_evaluation(f.evaluation, f.scene->loaded.scene, file, picture);
  if (!problem.empty()) throw std::runtime_error(problem);
}

py::object met(const PythonField& f, const std::vector<std::string>& specs) {
  const std::vector<Spec> asked = session::specs_of(specs, f.scene->loaded);
  return to_python(stoppable(py::none(), [&](Watch& watch) {
    return session::specs_json(session::met_specs(asked, f.scene->loaded, f.field(),
                                                  field_options(watch, 0, "auto")));
  }));
}

}  // namespace

void bind_field(py::module_& module) {
  using Class = PythonField;
  const auto statistic = [](auto member) {
    return [member](const Class& f) { return f.statistics.*member; };
  };
  const auto extreme = [](const Extreme& e) {
    return py::make_tuple(e.value, py::make_tuple(e.at.x(), e.at.y(), e.at.z()));
  };
  py::class_<Class, std::shared_ptr<Class>>(
      module, "Field", "A metric over the samples of a scene; SI units.")
      .def_property_readonly("values", values,
                             "float64 (n,): the metric; inf where it isn't finite. A "
                             "view of the field's own memory.")
      .def_property_readonly("points", points,
                             "float64 (n, 3): where, metres. A view, too.")
      .def_property_readonly(
          "observable",
          [](const std::shared_ptr<Class>& f) {
            return flags(f->field().observable, py::cast(f));
          },
          "bool (n,): whether every direction is observed.")
      .def_property_readonly(
          "inside",
          [](const std::shared_ptr<Class>& f) {
            return flags(f->field().inside, py::cast(f));
          },
          "bool (n,): within a solid; empty where none is near.")
      .def_property_readonly("metric", [](const Class& f) { return f.field().metric; })
      .def_property_readonly("unit", [](const Class& f) { return f.field().unit; })
      .def_property_readonly("mean", statistic(&FieldStatistics::mean),
                             "By volume where samples are adaptive.")
      .def_property_readonly("median", statistic(&FieldStatistics::median))
      .def_property_readonly("p95", statistic(&FieldStatistics::p95),
                             "95 % of the samples are at least as good.")
      .def_property_readonly("samples", statistic(&FieldStatistics::samples))
      .def_property_readonly(
          "best", [extreme](const Class& f) { return extreme(f.statistics.best()); },
          "(value, (x, y, z))")
      .def_property_readonly(
          "worst", [extreme](const Class& f) { return extreme(f.statistics.worst()); },
          "(value, (x, y, z))")
      .def(
          "json",
          [](const Class& f) {
            return to_python(session::field_answer(f.scene->loaded, f.field()));
          },
          "The document of `delos field --json`.")
      .def("meets", met, py::arg("specs"),
           "Which part of the samples meets each: ['coverage >= 3', 'eigmax <= 1 mm'].")
      .def("save", save_field, py::arg("file"), py::kw_only(), py::arg("log10") = false,
           py::arg("slice") = py::none(),
           "Write .vti, .vtu, .vtp, .csv, .json or .png. Raises RuntimeError.")
      .def("__len__", [](const Class& f) { return f.field().value.size(); })
      .def("__repr__", [](const Class& f) {
        return "<delos.Field " + f.field().metric + " of '" + f.field().scene + "', " +
               std::to_string(f.field().value.size()) + " samples>";
      });
  module.def("field", evaluate, py::arg("scene"), py::kw_only(), py::arg("threads") = 0,
             py::arg("solver") = "auto", py::arg("progress") = py::none(),
             "The field of a scene, or of a scene file.\n\n"
             "progress: called with (done, of) now and then; what it raises stops the "
             "work, as Ctrl-C does.");
}

}  // namespace delos::python
