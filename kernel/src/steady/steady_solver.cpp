#include "delos/steady/steady_solver.h"

#include <algorithm>

#include "delos/model/lanes.h"
#include "delos/rig/schedule.h"
#include "delos/scene/definition.h"
#include "layers/block.h"
#include "observe/measure.h"
#include "riccati/linear.h"
#include "steady/artemis.h"
#include "steady/bias.h"
#include "steady/chain_reduction.h"
#include "steady/continuous.h"
#include "steady/cycle.h"
#include "steady/stacked.h"
#include "steady/windows.h"

namespace delos {
namespace {

/// The fastest exact solver of a system.
Solver fastest(const System& system) {
  if (system.fusion == Fusion::artemis) return Solver::eigenvector;
  return is_reducible(system) ? Solver::spectral : Solver::doubling;
}

bool exposes(const System& system) {
  return std::any_of(system.devices.begin(), system.devices.end(),
                     [](const PlacedDevice& d) { return d.exposure > 0; });
}

/// @throws std::invalid_argument nobody knows the system's state a moment later
void check_lag_of(const System& system) {
  const std::string problem = lag_problem(system.motion, definition_of(system));
  if (system.lag > 0 && !problem.empty())
    throw std::invalid_argument("a lag " + problem);
}

/// @throws std::invalid_argument nobody knows what the devices' errors do
void check_bias_of(const System& system) {
  const std::string problem = bias_problem(system);
  if (!problem.empty()) throw std::invalid_argument(problem);
}

/// @throws std::invalid_argument the system has readings that take time, and can't
void check_exposures_of(const System& system) {
  if (!exposes(system)) return;
  const std::string problem = exposure_problem(system.motion, definition_of(system));
  if (!problem.empty()) throw std::invalid_argument("an exposure " + problem);
  if (!system.motion.own.empty())
    throw std::invalid_argument(
        "exposures and states of the devices' own aren't solved for together");
  for (const PlacedDevice& d : system.devices) {
    const bool of_pose =
        d.device->span() == Span::point || d.device->span() == Span::pose;
    if (d.exposure > 0 && !of_pose)
      throw std::invalid_argument(d.name +
                                  " measures more than the pose; an exposure is of "
                                  "the pose's mean");
    if (!(d.exposure >= 0 && d.exposure <= d.period))
      throw std::invalid_argument(d.name + ": its exposure isn't within its period");
  }
}

/// The solver that fits.
/// @throws UnsuitableSolver the wanted one doesn't
Solver suitable(const System& system, Solver wanted) {
  const Solver instead = fastest(system);
  switch (wanted) {
    case Solver::automatic:
      return instead;
    case Solver::spectral:
      if (!is_reducible(system))
        throw UnsuitableSolver(
            "the spectral solver needs a position, position_velocity or "
            "position_velocity_acceleration motion, devices that measure the pose "
            "alone and expose equally long, and stacked or continuous fusion",
            instead);
      break;
    case Solver::doubling:
      if (system.fusion == Fusion::artemis)
        throw UnsuitableSolver(
            "the doubling solver can't do artemis fusion, whose sum of Ψ matrices is "
            "no Riccati equation",
            instead);
      break;
    case Solver::eigenvector:
      if (system.fusion != Fusion::artemis && system.fusion != Fusion::stacked)
        throw UnsuitableSolver("the eigenvector solver can't do " +
                                   std::string(to_string(system.fusion)) + " fusion",
                               instead);
      if (exposes(system))
        throw UnsuitableSolver(
            "the eigenvector solver can't do devices that expose, whose A is singular",
            instead);
      break;
  }
  return wanted;
}

}  // namespace

SteadySolver::SteadySolver(const System& system, Solver solver)
    : system_(system),
      solver_(suitable(system, solver)),
      reports_(system.devices.size()) {
  check_exposures_of(system);
  check_lag_of(system);
  check_bias_of(system);
  if (solver_ == Solver::spectral)
    reduction_ = std::make_unique<const ChainReduction>(system);
  if (system.lag > 0) later_ = discretize(system.motion, system.lag);
}

SteadySolver::~SteadySolver() = default;

void SteadySolver::add_step(const MotionStep& motion, std::span<const int> devices) {
  for (const int device : devices)
    reports_[static_cast<std::size_t>(device)].push_back(
        {steps_.size(), {0, information_size(system_)}});
  const Eigen::Index n = motion.A.rows();
  steps_.push_back({motion, {StateMatrix::Zero(n, n), StateMatrix(0, n)}});
}

void SteadySolver::add_slots(std::span<const UpdateSlot> slots) {
  const ExposureWindows windows(system_, slots);
  for (std::size_t s = 0; s < slots.size(); ++s) {
    add_step(windows.motion(s), slots[s].devices);
    for (const int device : slots[s].devices)
      reports_[static_cast<std::size_t>(device)].back().read = windows.block(s, device);
  }
}

SteadyEquation SteadySolver::equation() const {
  const int columns = information_size(system_);
  const bool together = has_one_exposure(system_) && !reports_.front().empty();
  return {steps_, columns,
          together ? reports_.front().front().read : StateBlock{0, columns},
          std::vector<SteadyState>(steps_.size()), std::nullopt};
}

void SteadySolver::read(const LayerBlock& block, int lane, const TargetPose& pose,
                        SteadyEquation& at) const {
  at.clear();
  const std::size_t layer =
      static_cast<std::size_t>(packed_index(at.columns, 0)) * kLanes;
  const bool at_once =
      system_.fusion == Fusion::stacked || system_.fusion == Fusion::continuous;
  if (at_once && has_one_exposure(system_)) {
    at.add(0, at.block, block.total.data() + lane, kLanes);  // the weighted sum
  } else {
    for (CycleStep& step : at.steps)
      step.measurement.information.diagonal()
          .head(system_.motion.layout.coordinates())
          .setConstant(system_.prior);
    for (std::size_t i = 0; i < reports_.size(); ++i)
      for (const Report& report : reports_[i])
        at.add(report.step, report.read, block.layers.data() + i * layer + lane,
               kLanes);
  }
  const bool careful =
      reads_rows() || (reduction_ && reduction_->form_of(at).lacks_digits());
  if (careful) at.besides = system_.prior;
  if (!careful && !has_perfect_rows(block, lane)) return;

  // Rows without noise have no place in a layer, and the digits of readings that differ
  // much none in a sum: read them again, for the devices that have them at this pose.
  MeasureScratch measuring;
  for (std::size_t i = 0; i < reports_.size(); ++i) {
    if (!((careful ? block.seen[i] : block.perfect[i]) >> lane & 1)) continue;
    const auto keep = [&](const StateRow& row) {
      if (!row.perfect()) {
        if (!careful) return;
        const double weight =
            row.weight() * information_weight(system_, system_.devices[i]);
        for (const Report& report : reports_[i])
          at.add_reading(report.step, report.read, row.h, weight);
        return;
      }
      for (const Report& report : reports_[i])
        at.add_perfect(report.step, report.read, row.h.transpose());
    };
    measure(system_, system_.devices[i], pose, at.columns, measuring, keep);
  }
}

bool SteadySolver::reads_rows() const { return solver_ == Solver::doubling; }

bool SteadySolver::reduce(SteadyEquation& at, const SteadyRequest& request,
                          FusedState& out) const {
  at.form.reset();
  const Measurement& m = at.steps.front().measurement;
  if (!reduction_ || m.exact.rows() > 0) return false;
  at.form = reduction_->form_of(at);
  reduction_->solve(*at.form, request, out);
  return true;
}

void SteadySolver::solve(SteadyEquation& at, const SteadyRequest& request,
                         FusedState& out) const {
  if (reduce(at, request, out)) return;
  find(at, request, out);
  if (later_) carry(out);
}

// What is lost stays lost: the motion takes its directions to themselves.
void SteadySolver::carry(FusedState& out) const {
  for (StateMatrix* P :
       {&out.prior, &out.posterior, &out.worst_prior, &out.best_posterior}) {
    if (P->size() == 0) continue;
    const StateMatrix then = later_->A * *P * later_->A.transpose() + later_->Q;
    *P = riccati::projected_off((then + then.transpose()) / 2, out.unobservable);
  }
}

StateMatrix SmoothSteadySolver::adjoint(const SteadyEquation& at,
                                        const StateMatrix& Y) const {
  if (!later_ || at.form) return find_adjoint(at, Y);
  // ⟨Y, Φ P Φᵀ + Q⟩ has the slope Φᵀ Y Φ.
  const Eigen::Index n = later_->A.rows();
  StateMatrix whole = StateMatrix::Zero(n, n);
  whole.topLeftCorner(Y.rows(), Y.cols()) = Y;
  return find_adjoint(at, later_->A.transpose() * whole * later_->A);
}

std::unique_ptr<const SteadySolver> make_steady_solver(const System& system,
                                                       Solver solver) {
  switch (system.fusion) {
    case Fusion::stacked:
      return std::make_unique<StackedSolver>(system, solver);
    case Fusion::continuous:
      return std::make_unique<ContinuousSolver>(system, solver);
    case Fusion::periodic:
    case Fusion::sequential:
      return std::make_unique<CycleSolver>(system, solver);
    case Fusion::artemis:
      return std::make_unique<ArtemisSolver>(system, solver);
  }
  return nullptr;
}

std::string adjoint_problem(const System& system) {
  if (counts_bias(system))
    return "what errors of calibration do has no derivative here; use error: scatter";
  if (!has_one_exposure(system))
    return "fusion of devices that don't expose equally long has no derivative here";
  if (system.fusion == Fusion::stacked || is_reducible(system)) return "";
  return std::string(to_string(system.fusion)) +
         " fusion of this system has no derivative here";
}

std::unique_ptr<const SmoothSteadySolver> make_smooth_steady_solver(
    const System& system) {
  if (system.fusion == Fusion::stacked)
    return std::make_unique<StackedSolver>(system, Solver::automatic);
  return std::make_unique<ContinuousSolver>(system, Solver::automatic);
}

}  // namespace delos
