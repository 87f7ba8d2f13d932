#include "field/block_evaluator.h"

#include <algorithm>
#include <cmath>

namespace delos {
namespace {

double coverage(const LayerBlock& block, int lane) {
  return static_cast<double>(
      std::count_if(block.seen.begin(), block.seen.end(),
                    [lane](std::uint64_t seen) { return seen >> lane & 1; }));
}

}  // namespace

BlockEvaluator::BlockEvaluator(const FusionSolver& solver, const System& system,
                               const Metric& metric)
    : solver_(solver),
      system_(system),
      metric_(metric),
      need_(need_of(metric, system.motion.layout)),
      scratch_(solver.make_scratch()),
      P_(static_cast<std::size_t>(packed_index(kMaxCoordinates, 0)) * kLanes) {}

void BlockEvaluator::operator()(const LayerBlock& block, const TargetPose* poses,
                                PoseValue* values) {
  const bool in_lanes =
      solver_.solver() == Solver::spectral && need_ <= MetricNeed::pose_block;
  if (in_lanes) {
    solver_.pose_covariances(block, system_.covariance, P_.data(), lost_);
    if (need_ == MetricNeed::pose_block) {
      pose_metrics(metric_, system_.motion.layout, P_.data(), value_);
    }
  }
  for (int lane = 0; lane < block.lanes; ++lane) {
    // The rest of a pose that has lost directions needs more care.
    const bool done = in_lanes && solver_.spectral(block, lane) &&
                      (lost_[lane] == 0 || need_ == MetricNeed::nothing);
    values[lane] = done ? PoseValue{value_[lane], lost_[lane] == 0, lost_[lane]}
                        : solved_value(block, lane, poses[lane]);
    if (need_ == MetricNeed::nothing) values[lane].value = coverage(block, lane);
  }
}

PoseValue BlockEvaluator::solved_value(const LayerBlock& block, int lane,
                                       const TargetPose& pose) {
  solver_.solve(block, lane, pose, need_ == MetricNeed::time_constant, scratch_,
                state_);
  const double value =
      state_metric(metric_, system_.motion.layout, state_, system_.covariance);
  // A lost direction of the pose is lost with its derivatives.
  const int order = system_.motion.layout.order;
  const auto lost = static_cast<int>(state_.unobservable.cols());
  return {std::isfinite(value) ? value : std::numeric_limits<double>::infinity(),
          state_.status == RiccatiStatus::converged, (lost + order - 1) / order};
}

PoseValue combined(const PoseValue* values, std::size_t turns, OrientationRule rule,
                   bool larger_is_better) {
  PoseValue all = values[0];
  double sum = 0;
  for (std::size_t t = 0; t < turns; ++t) {
    const PoseValue& at = values[t];
    all.observable = all.observable && at.observable;
    all.lost = std::max(all.lost, at.lost);
    sum += at.value;
    // A blind orientation, +∞, is the worst of any metric.
    const bool worse =
        std::isinf(at.value) ||
        (!std::isinf(all.value) &&
         (larger_is_better ? at.value < all.value : at.value > all.value));
    if (worse) all.value = at.value;
  }
  if (rule == OrientationRule::mean) all.value = sum / static_cast<double>(turns);
  return all;
}

}  // namespace delos
