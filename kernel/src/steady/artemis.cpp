#include "steady/artemis.h"

#include <limits>

#include "steady/general_state.h"

namespace delos {

ArtemisSolver::ArtemisSolver(const System& system, Solver solver)
    : SteadySolver(system, solver) {
  for (int i = 0; i < static_cast<int>(system.devices.size()); ++i)
    add_step(
        discretize(system.motion, system.devices[static_cast<std::size_t>(i)].period),
        {&i, 1});
}

void ArtemisSolver::find(SteadyEquation& at, const SteadyRequest&,
                         FusedState& out) const {
  set_state(solve_eigenvector(at.steps), out);
  out.of = CovarianceOf::summed_psi;
  out.time_constant = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace delos
