#include "field/block_evaluator.h"

#include <algorithm>
#include <cmath>

#include "delos/model/infinity.h"
#include "delos/model/metric_expression.h"
#include "delos/steady/combine.h"
#include "layers/block.h"
#include "steady/chain_reduction.h"

namespace delos {
BlockEvaluator::BlockEvaluator(const SteadySolver& solver, const System& system,
                               const Metric& metric)
    : solver_(solver),
      system_(system),
      metric_(metric),
      need_(need_of(metric, system.motion.layout)),
      with_facts_(metric.expression || need_ == MetricNeed::nothing),
      with_footprint_(reads(metric, MetricKind::footprint)),
      request_(request_for(system, {&metric, 1})),
      equation_(solver.equation()),
      P_(static_cast<std::size_t>(packed_index(kMaxCoordinates, 0)) * kLanes) {
  if (reads_linearisation(metric)) {
    linearisation_.emplace(system);
    // Of the error before an update, whichever covariance the others are of.
    request_.prior = request_.whole_state = true;
  }
  if (!counts_bias(system) || need_ == MetricNeed::nothing) return;
  bias_.emplace(system);
  bias_->widen(request_);
}

void BlockEvaluator::operator()(const LayerBlock& block, const TargetPose* poses,
                                PoseValue* values, const Eigen::Vector3d* normals) {
  const auto normal = [&](int lane) -> Eigen::Vector3d {
    return normals ? normals[lane] : Eigen::Vector3d::Zero();
  };
  const ChainReduction* reduction = solver_.reduction();
  const bool in_lanes = reduction && need_ <= MetricNeed::pose_block && !bias_;
  if (in_lanes) {
    reduction->pose_covariances(block, P_.data(), lost_);
    for (int lane = 0; lane < block.lanes && with_facts_; ++lane)
      facts_[lane] =
          facts_of(system_, block, lane, poses[lane], with_footprint_, normal(lane));
    lane_metrics(metric_, system_.motion.layout, P_.data(), facts_, value_);
  }
  for (int lane = 0; lane < block.lanes; ++lane) {
    // The rest of a pose that has lost directions needs more care.
    const bool done = in_lanes && !has_perfect_rows(block, lane) &&
                      (lost_[lane] == 0 || need_ == MetricNeed::nothing);
    values[lane] =
        done ? PoseValue{value_[lane], lost_[lane] <= 0, std::max(lost_[lane], 0)}
             : solved_value(block, lane, poses[lane], normal(lane));
  }
}

PoseValue BlockEvaluator::solved_value(const LayerBlock& block, int lane,
                                       const TargetPose& pose,
                                       const Eigen::Vector3d& normal) {
  solver_.read(block, lane, pose, equation_);
  if (bias_) information_ = information_of(equation_);
  solver_.solve(equation_, request_, state_);
  PoseFacts facts = facts_of(system_, block, lane, pose, with_footprint_, normal);
  if (linearisation_) add_linearisation(state_, pose, *linearisation_, facts);
  // Of the scatter: linearising knows nothing of what is constantly off.
  if (bias_) (*bias_)(pose, information_, state_);
  const double value =
      state_metric(metric_, system_.motion.layout, state_, system_.covariance, facts);
  // A lost direction of the pose is lost with its derivatives.
  const int order = system_.motion.layout.order;
  const auto lost = static_cast<int>(state_.unobservable.cols());
  return {std::isfinite(value) ? value : kInfinity,
          state_.status == RiccatiStatus::converged, (lost + order - 1) / order};
}

PoseValue combined(const PoseValue* values, std::size_t turns, OrientationRule rule,
                   bool larger_is_better) {
  PoseValue all = values[0];
  for (std::size_t t = 1; t < turns; ++t) {
    all.observable = all.observable && values[t].observable;
    all.lost = std::max(all.lost, values[t].lost);
  }
  all.value = combine(rule, turns, larger_is_better, [values](std::size_t t) {
                return values[t].value;
              }).value;
  return all;
}

}  // namespace delos
