// Artemis fusion: the papers' sum of the devices' Ψ matrices.
#pragma once

#include "delos/steady/steady_solver.h"

namespace delos {

/// A step a device, of its own period. Source: Allen (2007), Table 3.3.
class ArtemisSolver final : public SteadySolver {
 public:
  /// @throws UnsuitableSolver
  ArtemisSolver(const System& system, Solver solver);

 private:
  void find(SteadyEquation& at, const SteadyRequest& request,
            FusedState& out) const override;
};

}  // namespace delos
