#include "errors.h"

#include "delos/device/faults.h"
#include "session/diagnostics_json.h"
#include "session/refusal.h"
#include "values.h"

namespace delos::python {
namespace {

/// The class, which the module keeps alive.
PyObject* g_scene_error = nullptr;

void raise_scene_error(const char* what, const Diagnostics& findings) {
  const py::object error = py::reinterpret_borrow<py::object>(g_scene_error)(what);
  error.attr("findings") = to_python(session::diagnostics_json(findings));
  PyErr_SetObject(g_scene_error, error.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const session::Refusal& refusal) {
    if (refusal.blame() == session::Blame::question)
      PyErr_SetString(PyExc_ValueError, refusal.what());
    else
      raise_scene_error(refusal.what(), refusal.findings());
  } catch (const Unbuildable& refusal) {
    raise_scene_error(refusal.what(), {});
  } catch (const DeviceFault& fault) {
    raise_scene_error(fault.what(), {});
  }
}

}  // namespace

void bind_errors(py::module_& module) {
  const py::object error = py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc(
      "delos.SceneError",
      "A scene or a device that is at fault.\n\n"
      "findings: a list of {severity, file, line, column, message}; empty where there "
      "is only the sentence.",
      PyExc_ValueError, nullptr));
  g_scene_error = error.ptr();
  error.inc_ref();
  module.attr("SceneError") = error;
  py::register_exception_translator(translate);
}

}  // namespace delos::python
