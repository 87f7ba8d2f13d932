#include "steady/stacked.h"

#include "delos/rig/schedule.h"
#include "steady/chain_reduction.h"
#include "steady/general_state.h"
#include "steady/single.h"

namespace delos {

StackedSolver::StackedSolver(const System& system, Solver solver)
    : SmoothSteadySolver(system, solver) {
  const UpdateSlot all{system.devices.front().period,
                       all_devices(system.devices.size())};
  add_slots({&all, 1});
}

void StackedSolver::find(SteadyEquation& at, const SteadyRequest& request,
                         FusedState& out) const {
  out.of = CovarianceOf::every_update;
  auto& [motion, measurement] = at.steps.front();
  if (system_.covariance == CovarianceKind::single) {
    at.states.front() = single_reading(measurement);
    set_state(at.states.front(), out);
    return;
  }
  const bool papers = solver() == Solver::eigenvector && measurement.exact.rows() == 0;
  at.states.front() =
      papers ? solve_eigenvector(at.steps) : solve_doubling(motion, measurement);
  if (may_lack_digits(at) &&
      at.take_readings({at.block.first, system_.motion.layout.coordinates()}))
    at.states.front() = solve_doubling(motion, measurement);
  const Eigen::Index n = system_.motion.layout.size();
  SteadyState state = at.states.front();
  restrict_to(n, state);
  set_state(state, out);
  if (request.time_constant)
    out.time_constant =
        time_constant_of_radius(radius_of(at, n), system_.devices.front().period);
}

StateMatrix StackedSolver::find_adjoint(const SteadyEquation& at,
                                        const StateMatrix& Y) const {
  if (at.form) return reduction()->adjoint(*at.form, Y);
  const auto& [motion, measurement] = at.steps.front();
  const Eigen::Index n = measurement.information.rows();
  StateMatrix whole = StateMatrix::Zero(n, n);
  whole.topLeftCorner(Y.rows(), Y.cols()) = Y;
  const auto [first, size] = at.block;
  if (system_.covariance == CovarianceKind::single)
    return single_reading_gradient(at.states.front(), whole)
        .block(first, first, size, size);
  return riccati_gradient(motion, measurement, at.states.front(), whole,
                          system_.covariance != CovarianceKind::prior)
      .block(first, first, size, size);
}

}  // namespace delos
