#include "delos/steady/steady_solver.h"

#include "delos/model/lanes.h"
#include "layers/block.h"
#include "observe/measure.h"
#include "steady/artemis.h"
#include "steady/chain_reduction.h"
#include "steady/continuous.h"
#include "steady/cycle.h"
#include "steady/stacked.h"

namespace delos {
namespace {

/// The fastest exact solver of a system.
Solver fastest(const System& system) {
  if (system.fusion == Fusion::artemis) return Solver::eigenvector;
  return is_reducible(system) ? Solver::spectral : Solver::doubling;
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
            "alone, and stacked or continuous fusion",
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
      break;
  }
  return wanted;
}

}  // namespace

SteadySolver::SteadySolver(const System& system, Solver solver)
    : system_(system),
      solver_(suitable(system, solver)),
      reports_(system.devices.size()) {
  if (solver_ == Solver::spectral)
    reduction_ = std::make_unique<const ChainReduction>(system);
}

SteadySolver::~SteadySolver() = default;

void SteadySolver::add_step(const MotionStep& motion, std::span<const int> devices) {
  const Eigen::Index n = system_.motion.layout.size();
  for (const int device : devices)
    reports_[static_cast<std::size_t>(device)].push_back(steps_.size());
  steps_.push_back({motion, {StateMatrix::Zero(n, n), StateMatrix(0, n)}});
}

SteadyEquation SteadySolver::equation() const {
  return {steps_, information_size(system_), std::vector<SteadyState>(steps_.size()),
          std::nullopt};
}

void SteadySolver::read(const LayerBlock& block, int lane, const TargetPose& pose,
                        SteadyEquation& at) const {
  at.clear();
  const std::size_t layer =
      static_cast<std::size_t>(packed_index(at.columns, 0)) * kLanes;
  if (system_.fusion == Fusion::stacked || system_.fusion == Fusion::continuous) {
    at.add(0, block.total.data() + lane, kLanes);  // the weighted sum
  } else {
    for (CycleStep& step : at.steps)
      step.measurement.information.diagonal()
          .head(system_.motion.layout.coordinates())
          .setConstant(system_.prior);
    for (std::size_t i = 0; i < reports_.size(); ++i)
      for (const std::size_t step : reports_[i])
        at.add(step, block.layers.data() + i * layer + lane, kLanes);
  }
  const bool careful = reads_rows();
  if (careful) at.besides = system_.prior;
  if (!careful && !has_perfect_rows(block, lane)) return;

  // Rows without noise have no place in a layer, and the digits of readings that differ
  // much none in a sum: read them again, for the devices that have them at this pose.
  MeasureScratch measuring;
  for (std::size_t i = 0; i < reports_.size(); ++i) {
    if (!((careful ? block.seen[i] : block.perfect[i]) >> lane & 1)) continue;
    const auto keep = [&](const StateRow& row) {
      if (!row.perfect()) {
        if (careful) at.add_reading(row.h, row.weight());
        return;
      }
      for (const std::size_t step : reports_[i])
        at.add_perfect(step, row.h.transpose());
    };
    measure(system_, system_.devices[i], pose, at.columns, measuring, keep);
  }
}

bool SteadySolver::reads_rows() const {
  return system_.fusion == Fusion::stacked && solver_ == Solver::doubling;
}

bool SteadySolver::reduce(SteadyEquation& at, const SteadyRequest& request,
                          FusedState& out) const {
  at.form.reset();
  const Measurement& m = at.steps.front().measurement;
  if (!reduction_ || m.exact.rows() > 0) return false;
  at.form =
      spectral_form(reduction_->L, m.information.topLeftCorner(at.columns, at.columns));
  reduction_->solve(*at.form, request, out);
  return true;
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
