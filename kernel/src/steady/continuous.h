// Continuous fusion: devices of many rates in the limit of frequent updates.
#pragma once

#include "delos/steady/steady_solver.h"

namespace delos {

/// S_c = Σ_i S_i/dt_i, an information rate, and the continuous Riccati equation.
class ContinuousSolver final : public SmoothSteadySolver {
 public:
  /// @throws UnsuitableSolver
  ContinuousSolver(const System& system, Solver solver);

 private:
  void find(SteadyEquation& at, const SteadyRequest& request,
            FusedState& out) const override;
  /// @pre the system is reducible
  [[nodiscard]] StateMatrix find_adjoint(const SteadyEquation& at,
                                         const StateMatrix& Y) const override;
  void solve_pinned(SteadyEquation& at, const SteadyRequest& request,
                    FusedState& out) const;
};

}  // namespace delos
