// Scenes in Python.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "session/loaded_scene.h"

namespace delos::python {

namespace py = pybind11;

/// A scene that is in order, and where it came from.
struct PythonScene {
  session::SceneSource source;
  session::LoadedScene loaded;
};

/// All devices that Python's scenes may name. Never destroyed: libraries stay open.
[[nodiscard]] PluginRegistry& plugins();

/// Python's hold of a scene; fields keep theirs.
using SceneHold = std::shared_ptr<PythonScene>;

/// A scene, or the file of one.
/// @throws Refusal
[[nodiscard]] SceneHold scene_of(const py::object& scene);

/// A scene that a search found, in the folder of the one that it began with.
[[nodiscard]] SceneHold found_scene(Scene scene, const PythonScene& began);

void bind_scene(py::module_& module);

}  // namespace delos::python
