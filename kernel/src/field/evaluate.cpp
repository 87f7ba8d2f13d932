#include "delos/field/evaluate.h"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

#include "field/metric_value.h"

namespace delos {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Metric and observability at one pose.
struct PoseValue {
  double value = kInfinity;
  bool observable = false;
};

/// Evaluates the poses of one block; one a thread.
class BlockEvaluator {
 public:
  BlockEvaluator(const FusionSolver& solver, const System& system, const Metric& metric)
      : solver_(solver),
        system_(system),
        metric_(metric),
        need_(need_of(metric, system.motion.layout)),
        scratch_(solver.make_scratch()) {}

  /// Values of all poses of a block.
  void operator()(const LayerBlock& block, const TargetPose* poses, PoseValue* values) {
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
      values[lane] = done ? PoseValue{value_[lane], lost_[lane] == 0}
                          : solved_value(block, lane, poses[lane]);
      if (need_ == MetricNeed::nothing) values[lane].value = coverage(block, lane);
    }
  }

 private:
  PoseValue solved_value(const LayerBlock& block, int lane, const TargetPose& pose) {
    solver_.solve(block, lane, pose, need_ == MetricNeed::time_constant, scratch_,
                  state_);
    const double value =
        state_metric(metric_, system_.motion.layout, state_, system_.covariance);
    return {std::isfinite(value) ? value : kInfinity,
            state_.status == RiccatiStatus::converged};
  }

  static double coverage(const LayerBlock& block, int lane) {
    return static_cast<double>(
        std::count_if(block.seen.begin(), block.seen.end(),
                      [lane](std::uint64_t seen) { return seen >> lane & 1; }));
  }

  const FusionSolver& solver_;
  const System& system_;
  const Metric& metric_;
  MetricNeed need_;
  FusionSolver::Scratch scratch_;
  std::vector<double> P_ = std::vector<double>(
      static_cast<std::size_t>(packed_index(kMaxCoordinates, 0)) * kLanes);
  double value_[kLanes] = {};
  int lost_[kLanes] = {};
  FusedState state_;
};

/// Values of the orientations at each point become one.
void combine(const std::vector<PoseValue>& poses, std::size_t turns,
             OrientationRule rule, bool larger_is_better, Field& field) {
  for (std::size_t p = 0; p < field.evaluated; ++p) {
    double sum = 0, worst = poses[p * turns].value;
    bool observable = true;
    for (std::size_t t = 0; t < turns; ++t) {
      const PoseValue& at = poses[p * turns + t];
      observable = observable && at.observable;
      sum += at.value;
      // A blind orientation, +∞, is the worst of any metric.
      const bool worse = std::isinf(at.value) ||
                         (!std::isinf(worst) &&
                          (larger_is_better ? at.value < worst : at.value > worst));
      if (worse) worst = at.value;
    }
    field.value[p] =
        rule == OrientationRule::worst ? worst : sum / static_cast<double>(turns);
    field.observable[p] = observable;
  }
}

}  // namespace

std::string metric_problem(const System& system, const Metric& metric) {
  if (metric.kind != MetricKind::latency || system.fusion != Fusion::artemis) return "";
  return "metric latency: artemis fusion has no closed loop; use stacked or continuous";
}

std::vector<TargetPose> field_poses(const Samples& samples,
                                    const Orientations& orientations) {
  std::vector<Eigen::Matrix3d> turns;
  for (const Eigen::Vector3d& rpy : orientations.rpy) {
    turns.push_back(rotation_from_rpy(rpy));
  }
  std::vector<TargetPose> poses;
  poses.reserve(samples.points.size() * turns.size());
  for (const Eigen::Vector3d& p : samples.points) {
    for (const Eigen::Matrix3d& R : turns) poses.push_back({R, p});
  }
  return poses;
}

Field evaluate_field(const InformationLayers& layers, const Samples& samples,
                     const Orientations& orientations, const Metric& metric,
                     const FieldOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const System& system = layers.system();
  if (const std::string problem = metric_problem(system, metric); !problem.empty()) {
    throw std::invalid_argument(problem);
  }
  const FusionSolver solver(system, options.solver);
  const std::size_t turns = orientations.rpy.size();
  const std::size_t poses = layers.poses().size(), blocks = layers.block_count();
  std::vector<PoseValue> values(poses);
  std::vector<unsigned char> done(blocks, 0);
  std::atomic<std::size_t> blocks_done = 0;
  std::exception_ptr failure;

  Field field;
  field.threads = options.threads > 0 ? options.threads : omp_get_max_threads();
#pragma omp parallel num_threads(field.threads)
  {
    BlockEvaluator evaluate(solver, system, metric);
    LayerBlock scratch;
#pragma omp for schedule(dynamic)
    for (std::size_t b = 0; b < blocks; ++b) {
      if (options.cancel && options.cancel->load(std::memory_order_relaxed)) continue;
      try {
        const LayerBlock& block = layers.block(b, scratch);
        const std::size_t first = b * kLanes;
        evaluate(block, layers.poses().data() + first, values.data() + first);
        done[b] = 1;
      } catch (...) {
#pragma omp critical
        if (!failure) failure = std::current_exception();
      }
      const std::size_t so_far = ++blocks_done;
      if (options.progress && omp_get_thread_num() == 0) {
        options.progress(std::min(so_far * kLanes, poses), poses);
      }
    }
  }
  if (failure) std::rethrow_exception(failure);

  const auto reached =
      static_cast<std::size_t>(std::find(done.begin(), done.end(), 0) - done.begin());
  field.metric = metric.name;
  field.unit = metric.unit;
  field.samples = samples;
  field.evaluations = std::min(reached * kLanes, poses);
  field.evaluated = field.evaluations / turns;
  field.cancelled = field.evaluated < samples.points.size();
  field.value.assign(samples.points.size(), kInfinity);
  field.observable.assign(samples.points.size(), 0);
  combine(values, turns, orientations.combine, metric.larger_is_better, field);
  field.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return field;
}

Field evaluate_field(const System& system, const Samples& samples,
                     const Orientations& orientations, const Metric& metric,
                     const FieldOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const InformationLayers layers(system, field_poses(samples, orientations),
                                 {.memory_limit = 0, .threads = options.threads});
  Field field = evaluate_field(layers, samples, orientations, metric, options);
  field.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return field;
}

}  // namespace delos
