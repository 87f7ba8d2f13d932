// Searches in Python: optimize, select, and studies.
#pragma once

#include <pybind11/pybind11.h>

namespace delos::python {

void bind_searches(pybind11::module_& module);

}  // namespace delos::python
