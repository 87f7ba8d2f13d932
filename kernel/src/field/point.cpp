#include "delos/field/point.h"

#include <cmath>
#include <limits>

#include "delos/model/infinity.h"
#include "rig/sight.h"
#include "steady/metric_value.h"

namespace delos {
namespace {

double coverage(const LayerBlock& block) {
  double seen = 0;
  for (const std::uint64_t word : block.seen) seen += static_cast<double>(word & 1);
  return seen;
}

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
                const LayerBlock& block) {
  if (metric.kind == MetricKind::coverage) return coverage(block);
  const double value =
      state_metric(metric, system.motion.layout, state, system.covariance);
  return std::isfinite(value) ? value : kInfinity;
}

/// The headline metric without the device; +∞ where nothing is left.
double value_without(System system, std::size_t device, const TargetPose& pose,
                     const Metric& metric, Solver solver) {
  system.devices.erase(system.devices.begin() + static_cast<std::ptrdiff_t>(device));
  if (system.devices.empty()) return kInfinity;
  const InformationLayers layers(system, {pose}, {.threads = 1});
  const FusionSolver fusion(system, solver);
  FusionSolver::Scratch scratch = fusion.make_scratch();
  LayerBlock empty;
  const LayerBlock& block = layers.block(0, empty);
  FusedState state;
  fusion.solve(block, 0, pose, metric.kind == MetricKind::latency, scratch, state);
  return value_of(metric, system, state, block);
}

/// By what fraction the metric gets worse from `with` to `without`.
double rise(double with, double without, bool larger_is_better) {
  if (!std::isfinite(with)) return 0;
  if (!std::isfinite(without)) return kInfinity;
  return larger_is_better ? with / without - 1 : without / with - 1;
}

}  // namespace

PointReport evaluate_point(const System& system, const TargetPose& pose,
                           const Metric& metric, Solver solver) {
  PointReport report;
  report.pose = pose;
  report.inside = inside_solid(system, pose.p);
  const InformationLayers layers(system, {pose}, {.threads = 1});
  const FusionSolver fusion(system, solver);
  FusionSolver::Scratch scratch = fusion.make_scratch();
  LayerBlock empty;
  const LayerBlock& block = layers.block(0, empty);

  report.careful = fusion.spectral(block, 0);
  report.solver = report.careful                        ? Solver::spectral
                  : fusion.solver() == Solver::spectral ? Solver::doubling
                                                        : fusion.solver();
  if (report.careful) {
    const Eigen::MatrixXd rows = weighted_rows(system, whitened_rows(system, pose));
    fusion.solve_rows(rows, true, report.state);
  } else {
    fusion.solve(block, 0, pose, true, scratch, report.state);
  }

  for (const std::string& name : metric_names(system.motion.layout)) {
    const Metric m = std::get<Metric>(parse_metric(name, system.motion.layout));
    report.metrics.push_back({m, value_of(m, system, report.state, block)});
  }

  report.residual = std::numeric_limits<double>::quiet_NaN();
  if (system.fusion == Fusion::stacked &&
      report.state.status == RiccatiStatus::converged) {
    report.residual = fusion.residual(block, 0, report.state);
  }

  const double with = value_of(metric, system, report.state, block);
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    DeviceShare share{system.devices[i].name, system.devices[i].type,
                      (block.seen[i] & 1) != 0, 0};
    if (share.visible) {
      share.share = rise(with, value_without(system, i, pose, metric, solver),
                         metric.larger_is_better);
    }
    report.devices.push_back(share);
  }
  return report;
}

}  // namespace delos
