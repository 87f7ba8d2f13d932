#include "options.h"

#include "session/named.h"

namespace delos::python {

FieldOptions field_options(Watch& watch, int threads, const std::string& solver) {
  FieldOptions options;
  options.solver = session::solver_named(solver);
  options.threads = threads;
  options.cancel = &watch.cancel;
  options.progress = [&watch](std::size_t done, std::size_t of) {
    watch.tell({done, of, std::nullopt});
  };
  return options;
}

}  // namespace delos::python
