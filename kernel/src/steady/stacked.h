// Stacked fusion: all devices report at every update.
#pragma once

#include "delos/steady/steady_solver.h"

namespace delos {

/// S = Σ_i S_i at one update, and one update's Riccati equation.
class StackedSolver final : public SmoothSteadySolver {
 public:
  /// @throws UnsuitableSolver
  StackedSolver(const System& system, Solver solver);

 private:
  void find(SteadyEquation& at, const SteadyRequest& request,
            FusedState& out) const override;
  [[nodiscard]] StateMatrix find_adjoint(const SteadyEquation& at,
                                         const StateMatrix& Y) const override;
};

}  // namespace delos
