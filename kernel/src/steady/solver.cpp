#include "delos/steady/solver.h"

namespace delos {

const char* to_string(Solver solver) {
  switch (solver) {
    case Solver::automatic:
      return "auto";
    case Solver::spectral:
      return "spectral";
    case Solver::doubling:
      return "doubling";
    case Solver::eigenvector:
      return "eigenvector";
  }
  return "";
}

UnsuitableSolver::UnsuitableSolver(const std::string& problem, Solver instead)
    : std::invalid_argument(problem + "; the " + to_string(instead) + " solver can"),
      problem_(problem),
      instead_(instead) {}

}  // namespace delos
