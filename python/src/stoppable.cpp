#include "stoppable.h"

namespace delos::python {

void call_progress(const py::object& progress, const Reached& at) {
  if (progress.is_none()) return;
  if (at.best)
    progress(at.done, at.of, *at.best);
  else
    progress(at.done, at.of);
}

}  // namespace delos::python
