// What is asked of scenes at points, of several, and over time.
#pragma once

#include <pybind11/pybind11.h>

namespace delos::python {

void bind_answers(pybind11::module_& module);

}  // namespace delos::python
