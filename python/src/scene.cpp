#include "scene.h"

#include <pybind11/stl/filesystem.h>

#include "delos/scene/io.h"
#include "session/refusal.h"
#include "values.h"

namespace delos::python {
namespace {

SceneHold loaded(session::SceneSource source) {
  const py::gil_scoped_release unlocked;
  session::LoadedScene scene = session::load(source, plugins());
  return std::make_shared<PythonScene>(
      PythonScene{std::move(source), std::move(scene)});
}

SceneHold changed(const PythonScene& scene, const py::dict& changes) {
  session::SceneSource source = scene.source;
  for (Override& change : overrides_of(changes))
    source.changes.push_back(std::move(change));
  return loaded(std::move(source));
}

/// What a keyword says of the scene as a whole.
void add(std::vector<Override>& changes, const char* path, const std::string& value) {
  if (!value.empty()) changes.push_back({path, value});
}

SceneHold load(const std::filesystem::path& file, const py::dict& set,
               const std::string& metric, const std::string& fusion,
               const std::string& covariance) {
  session::SceneSource source{file, std::nullopt, overrides_of(set)};
  add(source.changes, "metric", metric);
  add(source.changes, "fusion", fusion);
  add(source.changes, "covariance", covariance);
  return loaded(std::move(source));
}

SceneHold parse(const py::object& text, const std::filesystem::path& folder) {
  return loaded({folder / "scene.yaml", yaml_text(text), {}});
}

std::filesystem::path folder_of(const PythonScene& scene) {
  return scene.source.file.parent_path();
}

void save_file(const PythonScene& scene, const std::filesystem::path& file) {
  const std::string problem = save_scene(scene.loaded.scene, folder_of(scene), file);
  if (!problem.empty()) throw std::runtime_error(problem);
}

std::vector<std::string> device_names(const PythonScene& scene) {
  std::vector<std::string> names;
  for (const DeviceEntry& device : scene.loaded.scene.devices)
    names.push_back(device.name);
  return names;
}

}  // namespace

PluginRegistry& plugins() {
  static PluginRegistry& all = *new PluginRegistry;
  return all;
}

SceneHold scene_of(const py::object& scene) {
  if (py::isinstance<PythonScene>(scene)) return scene.cast<SceneHold>();
  return loaded({scene.cast<std::filesystem::path>(), std::nullopt, {}});
}

SceneHold found_scene(Scene scene, const PythonScene& began) {
  const std::string text = write_scene(scene);
  const py::gil_scoped_release unlocked;
  return std::make_shared<PythonScene>(
      PythonScene{{began.source.file, text, {}},
                  session::loaded_from(std::move(scene), plugins())});
}

void bind_scene(py::module_& module) {
  py::class_<PythonScene, SceneHold>(
      module, "Scene",
      "A scene that is in order. It doesn't change: set() gives "
      "another one.")
      .def_property_readonly("name",
                             [](const PythonScene& s) { return s.loaded.scene.name; })
      .def_property_readonly("metric",
                             [](const PythonScene& s) { return s.loaded.metric.name; })
      .def_property_readonly("devices", device_names, "Their names.")
      .def("set", changed, py::arg("changes"),
           "A scene with other values.\n\n"
           "changes: {path: value}, as {'devices.s1.at.z': 1.2, 'devices.s1.rate': "
           "'100 Hz'}; numbers are SI.\n"
           "Raises SceneError with all findings; the scene stays as it is.")
      .def(
          "text", [](const PythonScene& s) { return write_scene(s.loaded.scene); },
          "It as YAML in SI units.")
      .def("save", save_file, py::arg("file"),
           "Write it to a file, whole or not at all. Raises RuntimeError.")
      .def("__repr__", [](const PythonScene& s) {
        return "<delos.Scene '" + s.loaded.scene.name + "', " +
               std::to_string(s.loaded.system.devices.size()) + " devices>";
      });
  module.def("load", load, py::arg("file"), py::kw_only(), py::arg("set") = py::dict(),
             py::arg("metric") = "", py::arg("fusion") = "", py::arg("covariance") = "",
             "Read a scene file. Raises SceneError with all findings.\n\n"
             "set: {path: value}, changed before it is checked.");
  module.def(
      "parse", parse, py::arg("text"), py::kw_only(),
      py::arg("folder") = std::filesystem::path("."),
      "A scene from text, or from a dict of the same keys.\n\n"
      "folder: where relative paths start. Raises SceneError with all findings.");
}

}  // namespace delos::python
