#include "steady/stacked.h"

#include "steady/chain_reduction.h"
#include "steady/general_state.h"

namespace delos {

StackedSolver::StackedSolver(const System& system, Solver solver)
    : SmoothSteadySolver(system, solver) {
  add_step(discretize(system.motion, system.devices.front().period),
           all_devices(system.devices.size()));
}

void StackedSolver::solve(SteadyEquation& at, const SteadyRequest& request,
                          FusedState& out) const {
  if (reduce(at, request, out)) return;
  out.of = CovarianceOf::every_update;
  const auto& [motion, measurement] = at.steps.front();
  const bool papers = solver() == Solver::eigenvector && measurement.exact.rows() == 0;
  at.states.front() =
      papers ? solve_eigenvector(at.steps) : solve_doubling(motion, measurement);
  set_state(at.states.front(), out);
  if (request.time_constant)
    out.time_constant = time_constant_of_radius(closed_loop_radius(at.steps, at.states),
                                                system_.devices.front().period);
}

StateMatrix StackedSolver::adjoint(const SteadyEquation& at,
                                   const StateMatrix& Y) const {
  if (at.form) return reduction()->adjoint(*at.form, Y);
  const auto& [motion, measurement] = at.steps.front();
  const Eigen::Index n = measurement.information.rows();
  StateMatrix whole = StateMatrix::Zero(n, n);
  whole.topLeftCorner(Y.rows(), Y.cols()) = Y;
  return riccati_gradient(motion, measurement, at.states.front(), whole,
                          system_.covariance != CovarianceKind::prior)
      .topLeftCorner(at.columns, at.columns);
}

}  // namespace delos
