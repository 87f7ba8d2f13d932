// Starts that keep what places and numbers alone decide.
#pragma once

#include <string>
#include <vector>

#include "delos/optimize/problem.h"

namespace delos {

/// The nearest point of the unit cube, about, at which all of place_slacks() are kept.
struct Repair {
  std::vector<double> x;
  bool feasible = false;
  bool moved = false;
  std::vector<std::string> violated;  ///< constraints that aren't kept, at x where not
                                      ///< feasible, else at the start
};
[[nodiscard]] Repair repair(Problem& problem, std::vector<double> start);

}  // namespace delos
