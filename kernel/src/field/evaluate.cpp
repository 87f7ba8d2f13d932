#include "delos/field/evaluate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <utility>

#include "delos/model/infinity.h"
#include "delos/model/metric_expression.h"
#include "delos/parallel/each.h"
#include "field/place_evaluator.h"
#include "field/surface_normals.h"
#include "rig/sight.h"

namespace delos {
std::string metric_problem(const System& system, const Metric& metric) {
  if (reads_linearisation(metric)) {
    const std::string name = "metric " + metric.name + ": ";
    if (system.covariance == CovarianceKind::single)
      return name + "a single reading has no error before it; use covariance: prior";
    if (system.fusion == Fusion::artemis)
      return name +
             "artemis fusion is no filter's covariance; use stacked or "
             "continuous";
    if (system.lag > 0)
      return name + "is of the error at the readings; leave lag out, or set it to 0";
  }
  if (!reads(metric, MetricKind::latency)) return "";
  if (system.covariance == CovarianceKind::single)
    return "metric latency: a single reading has no closed loop; use covariance: prior";
  if (system.fusion != Fusion::artemis) return "";
  return "metric latency: artemis fusion has no closed loop; use stacked or continuous";
}

namespace {

std::size_t chunks_of(const Samples& samples) {
  return (samples.points.size() + kLanes - 1) / kLanes;
}

/// The kLanes poses of a chunk of points in one orientation.
void fill_poses(const Samples& samples, std::size_t chunk, const Eigen::Matrix3d& R,
                TargetPose* poses) {
  const std::size_t last = samples.points.size() - 1;
  for (std::size_t l = 0; l < kLanes; ++l)
    poses[l] = {R, samples.points[std::min(chunk * kLanes + l, last)]};
}

/// Layers of a field that are kept.
class KeptLayers {
 public:
  KeptLayers(const InformationLayers& layers, std::size_t turns)
      : layers_(layers), turns_(turns) {}
  void move_to(std::size_t chunk) { first_ = chunk * turns_; }
  const LayerBlock& block(std::size_t turn) {
    return layers_.block(first_ + turn, scratch_);
  }
  [[nodiscard]] const TargetPose* poses(std::size_t turn) const {
    return layers_.poses().data() + (first_ + turn) * kLanes;
  }

 private:
  const InformationLayers& layers_;
  std::size_t turns_, first_ = 0;
  LayerBlock scratch_;
};

/// The same worked out chunk by chunk and forgotten: nothing grows with the samples.
class FreshLayers {
 public:
  FreshLayers(const System& system, const Samples& samples,
              const std::vector<Eigen::Matrix3d>& turns)
      : system_(system),
        samples_(samples),
        turns_(turns),
        shape_(system),
        poses_(turns.size() * kLanes) {}
  void move_to(std::size_t chunk) {
    for (std::size_t t = 0; t < turns_.size(); ++t)
      fill_poses(samples_, chunk, turns_[t], &poses_[t * kLanes]);
  }
  const LayerBlock& block(std::size_t turn) {
    fill_block(system_, shape_, {poses(turn), kLanes}, block_);
    return block_;
  }
  [[nodiscard]] const TargetPose* poses(std::size_t turn) const {
    return &poses_[turn * kLanes];
  }

 private:
  const System& system_;
  const Samples& samples_;
  const std::vector<Eigen::Matrix3d>& turns_;
  LayerShape shape_;
  std::vector<TargetPose> poses_;
  LayerBlock block_;
};

/// A field without its values, all of them blind.
Field blind_field(const System& system, Samples samples, const Metric& metric) {
  const std::size_t points = samples.points.size();
  Field field;
  field.metric = metric.name;
  field.unit = metric.unit;
  field.larger_is_better = metric.larger_is_better;
  field.definition = definition_of(system);
  field.samples = std::move(samples);
  field.value.assign(points, kInfinity);
  field.observable.assign(points, 0);
  field.lost.assign(points, 0);
  return field;
}

/// @param make_layers(samples) what a thread reads their layers from
template <class MakeLayers>
Field evaluate_chunks(const System& system, Samples given,
                      const Orientations& orientations, const Metric& metric,
                      const FieldOptions& options, MakeLayers&& make_layers) {
  const auto start = std::chrono::steady_clock::now();
  if (const std::string problem = metric_problem(system, metric); !problem.empty())
    throw std::invalid_argument(problem);
  const auto solver = make_steady_solver(system, options.solver);
  const std::size_t turns = orientations.rpy.size();
  Field field = blind_field(system, std::move(given), metric);
  const Samples& samples = field.samples;
  const std::size_t points = samples.points.size(), chunks = chunks_of(samples);
  // Of whole chunks, as poses are.
  std::vector<Eigen::Vector3d> normals;
  if (reads(metric, MetricKind::footprint)) {
    normals = surface_normals(samples);
    normals.resize(chunks * kLanes, normals.back());
  }
  std::vector<unsigned char> done(chunks, 0);

  field.threads = thread_count(options.threads);
  LoopOptions loop{.threads = field.threads};
  if (options.cancel)
    loop.stop = [&] { return options.cancel->load(std::memory_order_relaxed); };
  if (options.progress)
    loop.progress = [&](std::size_t so_far) {
      options.progress(std::min(so_far * kLanes, points) * turns, points * turns);
    };
  each_with(chunks, loop, [&] {
    return [&, layers = make_layers(samples),
            evaluate = PlaceEvaluator(*solver, system, metric, orientations.combine,
                                      turns)](std::size_t c) mutable {
      PoseValue values[kLanes];
      layers.move_to(c);
      evaluate(
          kLanes,
          [&](std::size_t turn) -> const LayerBlock& { return layers.block(turn); },
          [&](std::size_t turn) { return layers.poses(turn); }, values,
          normals.empty() ? nullptr : &normals[c * kLanes]);
      const std::size_t first = c * kLanes;
      for (std::size_t p = first; p < std::min(first + kLanes, points); ++p) {
        field.value[p] = values[p - first].value;
        field.observable[p] = values[p - first].observable;
        field.lost[p] = static_cast<unsigned char>(values[p - first].lost);
      }
      done[c] = 1;
    };
  });

  const auto reached =
      static_cast<std::size_t>(std::find(done.begin(), done.end(), 0) - done.begin());
  field.evaluated = std::min(reached * kLanes, points);
  field.evaluations = field.evaluated * turns;
  field.cancelled = field.evaluated < points;
  // What other threads did beyond the first gap.
  const auto rest = static_cast<std::ptrdiff_t>(field.evaluated);
  std::fill(field.value.begin() + rest, field.value.end(), kInfinity);
  std::fill(field.observable.begin() + rest, field.observable.end(), 0);
  std::fill(field.lost.begin() + rest, field.lost.end(), 0);
  if (options.find_inside) field.inside = inside_solids(system, samples);
  field.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return field;
}

}  // namespace

std::vector<TargetPose> field_poses(const Samples& samples,
                                    const Orientations& orientations) {
  const std::vector<Eigen::Matrix3d> turns = rotations(orientations);
  std::vector<TargetPose> poses(chunks_of(samples) * kLanes * turns.size());
  TargetPose* next = poses.data();
  for (std::size_t c = 0; c < chunks_of(samples); ++c)
    for (const Eigen::Matrix3d& R : turns) {
      fill_poses(samples, c, R, next);
      next += kLanes;
    }
  return poses;
}

Field evaluate_field(const InformationLayers& layers, Samples samples,
                     const Orientations& orientations, const Metric& metric,
                     const FieldOptions& options) {
  return evaluate_chunks(
      layers.system(), std::move(samples), orientations, metric, options,
      [&](const Samples&) { return KeptLayers(layers, orientations.rpy.size()); });
}

Field evaluate_field(const System& system, Samples samples,
                     const Orientations& orientations, const Metric& metric,
                     const FieldOptions& options) {
  const std::vector<Eigen::Matrix3d> turns = rotations(orientations);
  return evaluate_chunks(
      system, std::move(samples), orientations, metric, options,
      [&](const Samples& kept) { return FreshLayers(system, kept, turns); });
}

}  // namespace delos
