#include "delos/field/point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "delos/field/evaluate.h"
#include "delos/model/infinity.h"
#include "delos/steady/state_metric.h"
#include "delos/steady/steady_solver.h"
#include "field/block_evaluator.h"
#include "field/error_budget.h"
#include "field/pose_facts.h"
#include "layers/block.h"
#include "rig/sight.h"
#include "steady/bias.h"
#include "steady/chain_reduction.h"

namespace delos {
namespace {

/// Whitened rows with the weight that fusion gives each device, and the prior's.
Eigen::MatrixXd weighted_rows(const System& system, const WhitenedRows& whitened) {
  Eigen::MatrixXd rows = whitened.rows;
  for (Eigen::Index r = 0; r < rows.rows(); ++r) {
    const auto device =
        static_cast<std::size_t>(whitened.device[static_cast<std::size_t>(r)]);
    rows.row(r) *= std::sqrt(information_weight(system, system.devices[device]));
  }
  if (system.prior == 0) return rows;
  const Eigen::Index measured = rows.rows(), d = system.motion.layout.coordinates();
  rows.conservativeResize(measured + d, Eigen::NoChange);
  rows.bottomRows(d).setZero();
  rows.bottomLeftCorner(d, d).diagonal().setConstant(std::sqrt(system.prior));
  return rows;
}

double value_of(const Metric& metric, const System& system, const FusedState& state,
                const LayerBlock& block, const TargetPose& pose) {
  if (!metric_problem(system, metric).empty()) return kInfinity;
  PoseFacts facts = facts_of(system, block, 0, pose, true);
  if (reads_linearisation(metric)) {
    LinearisationCheck check(system);
    add_linearisation(state, pose, check, facts);
  }
  const double value =
      state_metric(metric, system.motion.layout, state, system.covariance, facts);
  return std::isfinite(value) ? value : kInfinity;
}

/// The prior of what a step's equation is of: the motion's states, and the means that
/// exposing devices read, which begin anew at an update.
StateMatrix whole_prior(const MotionStep& motion, const FusedState& state) {
  const Eigen::Index n = state.prior.rows();
  if (motion.A.rows() == n) return state.prior;
  const StateMatrix A = motion.A.leftCols(n);
  return A * state.posterior * A.transpose() + motion.Q;
}

/// The state at the updates, of which the equation is.
FusedState state_at_update(const System& system, const LayerBlock& block,
                           const TargetPose& pose, const FusedState& used) {
  if (system.lag == 0) return used;
  System at_update = system;
  at_update.lag = 0;
  const auto fusion = make_steady_solver(at_update);
  SteadyEquation equation = fusion->equation();
  FusedState state;
  fusion->read(block, 0, pose, equation);
  fusion->solve(equation, {}, state);
  return state;
}

/// The headline metric without the device; +∞ where nothing is left.
double value_without(System system, std::size_t device, const TargetPose& pose,
                     const Metric& metric, Solver solver) {
  system.devices.erase(system.devices.begin() + static_cast<std::ptrdiff_t>(device));
  if (system.devices.empty() || !metric_problem(system, metric).empty())
    return kInfinity;
  const InformationLayers layers(system, {pose}, {.threads = 1});
  const auto fusion = make_steady_solver(system, solver);
  LayerBlock empty;
  PoseValue value[kLanes];
  BlockEvaluator(*fusion, system, metric)(layers.block(0, empty), &pose, value);
  return value[0].value;
}

System with_error(System system, ErrorPart part) {
  system.error = part;
  return system;
}

/// By what fraction the metric gets worse from `with` to `without`; NaN where it has no
/// value anyway.
double rise(double with, double without, bool larger_is_better) {
  if (!std::isfinite(with)) return std::numeric_limits<double>::quiet_NaN();
  if (!std::isfinite(without)) return kInfinity;
  if (with == without) return 0;
  // A formula may be 0 or less.
  if (with <= 0 || without <= 0)
    return (larger_is_better ? with - without : without - with) / std::abs(with);
  return larger_is_better ? with / without - 1 : without / with - 1;
}

}  // namespace

PointReport evaluate_point(const System& system, const TargetPose& pose,
                           const Metric& metric, Solver solver) {
  PointReport report;
  report.pose = pose;
  report.inside = inside_solid(system, pose.p);
  const InformationLayers layers(system, {pose}, {.threads = 1});
  const auto fusion = make_steady_solver(system, solver);
  SteadyEquation equation = fusion->equation();
  LayerBlock empty;
  const LayerBlock& block = layers.block(0, empty);
  const SteadyRequest everything{.time_constant = true};
  fusion->read(block, 0, pose, equation);

  // Before it is solved, which may take it apart.
  const bool doubtful = definition_of(system).error.has_value();
  const StateMatrix S = doubtful ? information_of(equation) : StateMatrix();
  report.careful = fusion->reduction() && !has_perfect_rows(block, 0);
  report.solver =
      fusion->reduction() && !report.careful ? Solver::doubling : fusion->solver();
  if (report.careful) {
    const Eigen::MatrixXd rows = weighted_rows(system, whitened_rows(system, pose));
    const ChainReduction& reduction = *fusion->reduction();
    reduction.solve(spectral_form_of_rows(reduction.L, rows), everything, report.state);
  } else {
    fusion->solve(equation, everything, report.state);
  }

  const KnownMetrics known{system.motion.layout, system.own_metrics};
  for (const std::string& name : metric_names(known)) {
    const Metric m = std::get<Metric>(parse_metric(name, known));
    report.metrics.push_back({m, value_of(m, system, report.state, block, pose)});
  }

  report.residual = std::numeric_limits<double>::quiet_NaN();
  if (system.fusion == Fusion::stacked && !has_perfect_rows(block, 0) &&
      system.covariance != CovarianceKind::single &&
      report.state.status == RiccatiStatus::converged) {
    const auto& [motion, measurement] = equation.steps.front();
    report.residual = riccati_residual(
        motion, measurement,
        whole_prior(motion, state_at_update(system, block, pose, report.state)));
  }

  const FusedState scatter = report.state;
  for (const PlacedDevice& device : system.devices)
    report.devices.push_back({device.name, device.type});
  if (doubtful && bias_problem(with_error(system, ErrorPart::total)).empty())
    add_budget(system, {pose, block, S, scatter}, metric, report);

  const auto same =
      std::find_if(report.metrics.begin(), report.metrics.end(),
                   [&](const MetricValue& m) { return m.metric.name == metric.name; });
  const double with = same != report.metrics.end()
                          ? same->value
                          : value_of(metric, system, report.state, block, pose);
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    DeviceShare& share = report.devices[i];
    share.visible = (block.seen[i] & 1) != 0;
    if (share.visible)
      share.share = rise(with, value_without(system, i, pose, metric, solver),
                         metric.larger_is_better);
  }
  return report;
}

}  // namespace delos
