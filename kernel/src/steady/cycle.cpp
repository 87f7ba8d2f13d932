#include "steady/cycle.h"

#include <numeric>
#include <stdexcept>

#include "delos/model/infinity.h"
#include "delos/riccati/cycle.h"
#include "delos/rig/schedule.h"
#include "steady/general_state.h"

namespace delos {

CycleSolver::CycleSolver(const System& system, Solver solver)
    : SteadySolver(system, solver) {
  const auto cycle = update_cycle(system);
  if (const auto* problem = std::get_if<std::string>(&cycle))
    throw std::invalid_argument(*problem);
  const auto& slots = std::get<std::vector<UpdateSlot>>(cycle);
  add_slots(slots);
  for (const UpdateSlot& slot : slots) intervals_.push_back(slot.interval);
}

void CycleSolver::find(SteadyEquation& at, const SteadyRequest& request,
                       FusedState& out) const {
  solve_cycle(at.steps, at.states);
  if (may_lack_digits(at) && at.take_readings({0, system_.motion.layout.coordinates()}))
    solve_cycle(at.steps, at.states);
  out.status = RiccatiStatus::converged;
  for (const SteadyState& state : at.states)
    if (state.status != RiccatiStatus::converged) out.status = state.status;
  const Eigen::Index n = system_.motion.layout.size();
  if (request.time_constant) {
    const double length = std::accumulate(intervals_.begin(), intervals_.end(), 0.0);
    out.time_constant = out.status == RiccatiStatus::converged
                            ? time_constant_of_radius(radius_of(at, n), length)
                            : kInfinity;
  }
  for (SteadyState& state : at.states) restrict_to(n, state);

  const Eigen::Index d = system_.motion.layout.coordinates();
  const auto size = [d](const StateMatrix& P) { return P.topLeftCorner(d, d).trace(); };
  out.unobservable = at.states.back().unobservable;
  out.worst_prior = at.states.front().prior;
  out.best_posterior = at.states.front().posterior;
  for (const SteadyState& state : at.states) {
    if (size(state.prior) > size(out.worst_prior)) out.worst_prior = state.prior;
    if (size(state.posterior) < size(out.best_posterior))
      out.best_posterior = state.posterior;
  }
  set_mean(at, out);
}

void CycleSolver::set_mean(const SteadyEquation& at, FusedState& out) const {
  if (system_.fusion == Fusion::periodic) {
    out.of = CovarianceOf::time_average;
    out.prior =
        time_average(system_.motion, intervals_, at.states, AverageRule::trapezoid);
    out.posterior = out.prior;
    return;
  }
  out.of = CovarianceOf::turn_average;
  const Eigen::Index n = system_.motion.layout.size();
  out.prior.setZero(n, n);
  out.posterior.setZero(n, n);
  for (const SteadyState& state : at.states) {
    out.prior += state.prior;
    out.posterior += state.posterior;
  }
  out.prior /= static_cast<double>(at.states.size());
  out.posterior /= static_cast<double>(at.states.size());
}

}  // namespace delos
