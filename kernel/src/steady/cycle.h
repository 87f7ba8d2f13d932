// Periodic and sequential fusion: a cycle of updates, solved exactly.
#pragma once

#include <vector>

#include "delos/steady/steady_solver.h"

namespace delos {

/// update_cycle() of the devices, and what it amounts to: the mean over time, or over
/// turns, the worst prior and the best posterior.
class CycleSolver final : public SteadySolver {
 public:
  /// @throws UnsuitableSolver
  /// @throws std::invalid_argument the rates have no short cycle
  CycleSolver(const System& system, Solver solver);

 private:
  void find(SteadyEquation& at, const SteadyRequest& request,
            FusedState& out) const override;
  void set_mean(const SteadyEquation& at, FusedState& out) const;

  std::vector<double> intervals_;  // seconds that lead to each step
};

}  // namespace delos
