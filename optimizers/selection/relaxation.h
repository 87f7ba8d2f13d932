// The least cost of fractional choices, and a lower bound of it.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <vector>

#include "selection/cost.h"
#include "selection/polytope.h"

namespace delos {

/// When to be satisfied.
struct RelaxationOptions {
  double tolerance = 1e-3;     ///< relative, of what is left between f̃ and the bound
  double cutoff = 0;           ///< > 0: a bound above that is enough
  int steps = 400;             ///< at most
  std::function<bool()> stop;  ///< asked before each step
};

/// What a relaxation found.
struct Relaxation {
  std::vector<double> w;               ///< the best fractional choice
  double value = 0;                    ///< f̃(w)
  double bound = 0;                    ///< no choice of the polytope costs less
  ChoicePolytope::LinearBound linear;  ///< of the tangent that gave the bound
};

/// Minimise f over a polytope by projected gradients with Barzilai and Borwein's steps.
/// Every tangent met gives a bound, level + min_v slope·(v − w), of which the best is
/// kept: it holds wherever the search ends.
///
/// Source: Birgin, Martínez, Raydan (2000), SIAM J. Optim. 10(4), 1196–1211.
/// @param start any point; where it is blind everything is chosen a little
[[nodiscard]] Relaxation relax(ChoiceCost& cost, const ChoicePolytope& polytope,
                               std::vector<double> start,
                               const RelaxationOptions& options);

}  // namespace delos
