// Fields of a system: the metric at every sample.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

#include "delos/api.h"
#include "delos/field/field.h"
#include "delos/layers/layers.h"
#include "delos/model/metric.h"
#include "delos/rig/system.h"
#include "delos/sampling/samples.h"
#include "delos/scene/scene.h"
#include "delos/steady/solver.h"

namespace delos {

/// How a field is evaluated.
struct FieldOptions {
  Solver solver = Solver::automatic;
  int threads = 0;  ///< 0: as many as OpenMP gives
  /// Called now and then, from one thread, with poses done and poses in all.
  std::function<void(std::size_t, std::size_t)> progress;
  const std::atomic<bool>* cancel =
      nullptr;              ///< set: stop soon and return what there is
  bool find_inside = true;  ///< false: leave Field::inside empty
};

/// Empty where the metric is defined for the system; else a sentence that says why not.
[[nodiscard]] DELOS_API std::string metric_problem(const System& system,
                                                   const Metric& metric);

/// The poses of a field, kLanes points at a time: the points in the first orientation,
/// then in the next. The last point stands in where the last kLanes aren't full.
[[nodiscard]] DELOS_API std::vector<TargetPose> field_poses(
    const Samples& samples, const Orientations& orientations);

/// Evaluate a metric over samples, from layers of their poses.
///
/// Each block of 64 poses is worked out by itself, so the bytes of the answer don't
/// depend on the number of threads.
/// @param samples kept in the field: move millions of them in
/// @pre layers.poses() came from field_poses() of the same samples and orientations
/// @throws std::invalid_argument as make_steady_solver(); or latency under artemis
/// fusion, which
///         has no closed loop.
[[nodiscard]] DELOS_API Field evaluate_field(const InformationLayers& layers,
                                             Samples samples,
                                             const Orientations& orientations,
                                             const Metric& metric,
                                             const FieldOptions& options = {});

/// The same in one go, without keeping layers.
[[nodiscard]] DELOS_API Field evaluate_field(const System& system, Samples samples,
                                             const Orientations& orientations,
                                             const Metric& metric,
                                             const FieldOptions& options = {});

/// How a second field differs from a first on the same samples; parts and means are by
/// volume where the first has weights.
struct Comparison {
  double mean = 0;               ///< of second − first, where both are finite
  double min = 0;                ///< the largest fall
  double max = 0;                ///< the largest rise
  double improved_fraction = 0;  ///< of all samples: better by more than 1e-9
                                 ///< relative, or finite where it wasn't
  std::size_t common = 0;        ///< samples where both are finite
  Field difference;              ///< second − first; +∞ where either isn't finite
};

/// @pre both fields have the same points and metric
[[nodiscard]] DELOS_API Comparison compare_fields(const Field& first,
                                                  const Field& second);

}  // namespace delos
