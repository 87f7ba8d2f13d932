#include "simulation/expectation.h"

#include <numeric>
#include <optional>
#include <stdexcept>

#include "delos/layers/layers.h"
#include "delos/model/infinity.h"
#include "delos/model/lanes.h"
#include "delos/steady/steady_solver.h"
#include "steady/bias.h"

namespace delos {
namespace {

/// Solve a system at a pose.
/// @param[out] bias what constant errors add, n×n; null: it isn't asked for
FusedState solve(const System& system, const TargetPose& pose, SteadyEquation& at,
                 StateMatrix* bias = nullptr) {
  const InformationLayers layers(system, {pose}, {.threads = 1});
  const auto solver = make_steady_solver(system);
  at = solver->equation();
  LayerBlock empty;
  FusedState state;
  solver->read(layers.block(0, empty), 0, pose, at);
  const bool counts = bias && counts_bias(system);
  const StateMatrix S = counts ? information_of(at) : StateMatrix();
  solver->solve(at, {.time_constant = true}, state);
  if (state.status != RiccatiStatus::converged)
    throw std::invalid_argument(
        "not every direction is observed there, so that no filter settles; `delos "
        "point` says which are lost");
  if (!bias) return state;
  const int n = system.motion.layout.size();
  bias->setZero(n, n);
  if (!counts) return state;
  CalibrationScratch scratch;
  const StateMatrix B = BiasSolver(system).covariance(
      S, calibration_spread(system, pose, scratch), state);
  bias->topLeftCorner(B.rows(), B.cols()) = B;
  return state;
}

CovarianceLook look(const char* name, const StateMatrix& predicted, std::size_t slots) {
  return {name, predicted, std::vector<double>(slots), std::vector<double>(slots)};
}

/// The slot whose covariance has the largest trace over the pose block, or the least.
std::size_t extreme_slot(const std::vector<SteadyState>& states, bool prior, bool worst,
                         int d) {
  std::size_t found = 0;
  const auto size = [&](std::size_t s) {
    const StateMatrix& P = prior ? states[s].prior : states[s].posterior;
    return P.topLeftCorner(d, d).trace();
  };
  for (std::size_t s = 1; s < states.size(); ++s)
    if (worst ? size(s) > size(found) : size(s) < size(found)) found = s;
  return found;
}

/// All instants' means, and the extremes, of a cycle.
void look_at_cycle(const System& system, const FusedState& fused, Expectation& all) {
  const std::size_t slots = all.slots.size();
  const int d = system.motion.layout.coordinates();
  if (system.fusion == Fusion::sequential) {
    const auto each = 1 / static_cast<double>(slots);
    CovarianceLook prior = look("prior", fused.prior, slots);
    CovarianceLook posterior = look("posterior", fused.posterior, slots);
    prior.prior.assign(slots, each);
    posterior.posterior.assign(slots, each);
    all.looks = {std::move(prior), std::move(posterior)};
    if (system.covariance == CovarianceKind::posterior)
      std::swap(all.looks[0], all.looks[1]);
  } else {
    // The trapezoid rule, as CovarianceOf::time_average has it: over each interval the
    // mean of the posterior before it and of the prior at its end.
    CovarianceLook average = look("average", fused.prior, slots);
    double length = 0;
    for (const UpdateSlot& slot : all.slots) length += slot.interval;
    for (std::size_t s = 0; s < slots; ++s) {
      const double half = all.slots[s].interval / (2 * length);
      average.prior[s] += half;
      average.posterior[(s + slots - 1) % slots] += half;
    }
    all.looks = {std::move(average)};
  }
  const std::size_t worst = extreme_slot(all.states, true, true, d);
  const std::size_t best = extreme_slot(all.states, false, false, d);
  all.looks.push_back(look("worst prior", all.states[worst].prior, slots));
  all.looks.back().prior[worst] = 1;
  all.looks.push_back(look("best posterior", all.states[best].posterior, slots));
  all.looks.back().posterior[best] = 1;
}

}  // namespace

std::vector<UpdateSlot> simulated_slots(const System& system) {
  if (system.covariance == CovarianceKind::single)
    throw std::invalid_argument(
        "covariance: single is of one reading without a motion, which there is nothing "
        "to simulate of; use --covariance prior or posterior");
  if (system.fusion == Fusion::artemis)
    throw std::invalid_argument(
        "artemis fusion is no filter's covariance; use --fusion continuous or "
        "periodic");
  if (system.fusion == Fusion::stacked) {
    UpdateSlot all{system.devices.front().period, {}};
    all.devices.resize(system.devices.size());
    std::iota(all.devices.begin(), all.devices.end(), 0);
    return {all};
  }
  auto cycle = update_cycle(system);
  if (const auto* problem = std::get_if<std::string>(&cycle))
    throw std::invalid_argument(*problem);
  return std::get<std::vector<UpdateSlot>>(std::move(cycle));
}

std::vector<StateVector> steady_variances(const System& system,
                                          const std::vector<TargetPose>& poses,
                                          CovarianceKind kind) {
  const InformationLayers layers(system, poses, {.threads = 1});
  const auto solver = make_steady_solver(system);
  SteadyEquation at = solver->equation();
  LayerBlock scratch;
  FusedState state;
  std::optional<BiasSolver> bias;
  if (counts_bias(system)) bias.emplace(system);
  std::vector<StateVector> variances;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const LayerBlock& block = layers.block(i / kLanes, scratch);
    solver->read(block, static_cast<int>(i % kLanes), poses[i], at);
    const StateMatrix S = bias ? information_of(at) : StateMatrix();
    solver->solve(at, {}, state);
    if (bias) (*bias)(poses[i], S, state);
    StateVector of = state.covariance(kind).diagonal();
    for (Eigen::Index k = 0; k < of.size() && state.unobservable.cols() > 0; ++k)
      if (state.unobservable.row(k).cwiseAbs().maxCoeff() > 1e-9) of(k) = kInfinity;
    variances.push_back(std::move(of));
  }
  return variances;
}

Expectation expectation(const System& system, const TargetPose& pose) {
  Expectation all;
  all.slots = simulated_slots(system);
  SteadyEquation at;
  const FusedState fused = solve(system, pose, at, &all.bias);
  all.time_constant = fused.time_constant;
  if (system.fusion == Fusion::stacked) {
    SteadyState state;
    state.prior = fused.prior;
    state.posterior = fused.posterior;
    all.states = {state};
    CovarianceLook prior = look("prior", fused.prior, 1);
    CovarianceLook posterior = look("posterior", fused.posterior, 1);
    prior.prior = posterior.posterior = {1};
    all.looks = {std::move(prior), std::move(posterior)};
    if (system.covariance == CovarianceKind::posterior)
      std::swap(all.looks[0], all.looks[1]);
  } else {
    if (system.fusion == Fusion::continuous) {
      // Its rates' true instants, of which it is the limit.
      System periodic = system;
      periodic.fusion = Fusion::periodic;
      solve(periodic, pose, at);
    }
    all.states = at.states;
    look_at_cycle(system, fused, all);
  }
  for (CovarianceLook& look : all.looks) look.predicted += all.bias;
  return all;
}

}  // namespace delos
