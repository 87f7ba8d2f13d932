// The package's compiled part.
#include <pybind11/pybind11.h>

#include "answers.h"
#include "devices.h"
#include "errors.h"
#include "field.h"
#include "scene.h"
#include "searches.h"

PYBIND11_MODULE(_delos, module) {
  module.doc() = "Design-space explorer for tracking systems; see the package delos.";
  module.attr("__version__") = DELOS_VERSION;
  delos::python::bind_errors(module);
  delos::python::bind_scene(module);
  delos::python::bind_field(module);
  delos::python::bind_answers(module);
  delos::python::bind_searches(module);
  delos::python::bind_devices(module);
}
