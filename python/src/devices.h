// Devices that are written in Python: slow, for a first try.
#pragma once

#include <pybind11/pybind11.h>

namespace delos::python {

void bind_devices(pybind11::module_& module);

}  // namespace delos::python
