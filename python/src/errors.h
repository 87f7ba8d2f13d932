// What Python raises where C++ throws.
#pragma once

#include <pybind11/pybind11.h>

namespace delos::python {

/// SceneError, with `findings`, of scenes and plugins; ValueError of what was asked.
void bind_errors(pybind11::module_& module);

}  // namespace delos::python
