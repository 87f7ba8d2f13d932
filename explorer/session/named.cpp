#include "session/named.h"

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

}  // namespace delos::session
