#include "session/named.h"

#include <vector>

#include "delos/text/words.h"
#include "session/refusal.h"

namespace delos::session {

Solver solver_named(const std::string& name) {
  for (const Solver s :
       {Solver::automatic, Solver::spectral, Solver::doubling, Solver::eigenvector})
    if (name == to_string(s)) return s;
  throw Refusal(
      Blame::question,
      "solver '" + name + "': choose auto, spectral, doubling or eigenvector");
}

FilterKind filter_named(const std::string& name) {
  for (const FilterKind kind : {FilterKind::extended, FilterKind::iterated,
                                FilterKind::sequential, FilterKind::unscented})
    if (name == to_string(kind)) return kind;
  throw Refusal(
      Blame::question,
      "filter '" + name + "': choose extended, iterated, sequential or unscented");
}

ScatteredMethod scattered_method_named(const std::string& name, const char* what) {
  std::vector<std::string> known;
  for (const ScatteredMethod method : kScatteredMethods) {
    if (name == to_string(method)) return method;
    known.emplace_back(to_string(method));
  }
  throw Refusal(Blame::question, what + (" '" + name) + "': choose " + joined(known));
}

int axis_named(const std::string& name, const char* what) {
  for (int axis = 0; axis < 3; ++axis)
    if (name == std::string(1, "xyz"[axis])) return axis;
  throw Refusal(Blame::question, what + (" '" + name) + "': choose x, y or z");
}

}  // namespace delos::session
