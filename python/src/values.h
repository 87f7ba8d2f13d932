// Values of the session as Python's.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "delos/document/override.h"
#include "session/json.h"

namespace delos::python {

namespace py = pybind11;

/// A document as dicts, lists, strings and numbers; null is None.
[[nodiscard]] py::object to_python(const session::Json& json);

/// {path: value} as changes: numbers by all their digits, strings as a scene writes
/// them, lists and dicts as JSON, which is YAML.
[[nodiscard]] std::vector<Override> overrides_of(const py::dict& changes);

/// Text that a scene's reader takes for this value.
[[nodiscard]] std::string yaml_text(const py::handle& value);

/// Three numbers of any sequence.
/// @throws py::value_error there aren't three
[[nodiscard]] Eigen::Vector3d three(const py::object& numbers, const char* what);

/// An array over memory that `owner` keeps alive: nothing is copied, and it can't be
/// written to.
template <class T>
py::array view(const T* data, std::vector<py::ssize_t> shape, const py::object& owner) {
  py::array all(py::dtype::of<T>(), std::move(shape), data, owner);
  py::detail::array_proxy(all.ptr())->flags &=
      ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return all;
}

}  // namespace delos::python
