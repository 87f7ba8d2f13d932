#include "delos/field/evaluate.h"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <stdexcept>

#include "delos/model/infinity.h"
#include "delos/model/metric_expression.h"
#include "field/place_evaluator.h"
#include "parallel/first_failure.h"
#include "rig/sight.h"

namespace delos {
std::string metric_problem(const System& system, const Metric& metric) {
  if (!reads(metric, MetricKind::latency)) return "";
  if (system.covariance == CovarianceKind::single)
    return "metric latency: a single reading has no closed loop; use covariance: prior";
  if (system.fusion != Fusion::artemis) return "";
  return "metric latency: artemis fusion has no closed loop; use stacked or continuous";
}

std::vector<TargetPose> field_poses(const Samples& samples,
                                    const Orientations& orientations) {
  std::vector<Eigen::Matrix3d> turns;
  for (const Eigen::Vector3d& rpy : orientations.rpy) {
    turns.push_back(rotation_from_rpy(rpy));
  }
  const std::size_t points = samples.points.size();
  const std::size_t chunks = (points + kLanes - 1) / kLanes;
  std::vector<TargetPose> poses;
  poses.reserve(chunks * kLanes * turns.size());
  for (std::size_t c = 0; c < chunks; ++c) {
    for (const Eigen::Matrix3d& R : turns) {
      for (std::size_t l = 0; l < kLanes; ++l) {
        poses.push_back({R, samples.points[std::min(c * kLanes + l, points - 1)]});
      }
    }
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
  const auto solver = make_steady_solver(system, options.solver);
  const std::size_t turns = orientations.rpy.size();
  const std::size_t points = samples.points.size();
  const std::size_t chunks = (points + kLanes - 1) / kLanes;
  std::vector<PoseValue> values(chunks * kLanes);
  std::vector<unsigned char> done(chunks, 0);
  std::atomic<std::size_t> chunks_done = 0;
  FirstFailure failure;

  Field field;
  field.threads = options.threads > 0 ? options.threads : omp_get_max_threads();
#pragma omp parallel num_threads(field.threads)
  {
    PlaceEvaluator evaluate(*solver, system, metric, orientations.combine, turns);
    LayerBlock scratch;
#pragma omp for schedule(dynamic)
    for (std::size_t c = 0; c < chunks; ++c) {
      if (options.cancel && options.cancel->load(std::memory_order_relaxed)) continue;
      failure.guard([&] {
        const auto block = [&](std::size_t turn) -> const LayerBlock& {
          return layers.block(c * turns + turn, scratch);
        };
        const auto poses = [&](std::size_t turn) {
          return layers.poses().data() + (c * turns + turn) * kLanes;
        };
        evaluate(kLanes, block, poses, &values[c * kLanes]);
        done[c] = 1;
      });
      const std::size_t so_far = ++chunks_done;
      if (options.progress && omp_get_thread_num() == 0) {
        options.progress(std::min(so_far * kLanes, points) * turns, points * turns);
      }
    }
  }
  failure.rethrow();

  const auto reached =
      static_cast<std::size_t>(std::find(done.begin(), done.end(), 0) - done.begin());
  field.metric = metric.name;
  field.unit = metric.unit;
  field.larger_is_better = metric.larger_is_better;
  field.definition = {system.fusion, system.covariance};
  field.samples = samples;
  field.evaluated = std::min(reached * kLanes, points);
  field.evaluations = field.evaluated * turns;
  field.cancelled = field.evaluated < points;
  field.value.assign(points, kInfinity);
  field.observable.assign(points, 0);
  field.lost.assign(points, 0);
  for (std::size_t p = 0; p < field.evaluated; ++p) {
    field.value[p] = values[p].value;
    field.observable[p] = values[p].observable;
    field.lost[p] = static_cast<unsigned char>(values[p].lost);
  }
  if (options.find_inside) field.inside = inside_solids(system, samples);
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
