// Fields in Python.
#pragma once

#include <pybind11/pybind11.h>

namespace delos::python {

void bind_field(pybind11::module_& module);

}  // namespace delos::python
