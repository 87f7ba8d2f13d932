// Metrics of a steady state. Equations: Allen (2007), §4.3.
#pragma once

#include <Eigen/Core>

#include "delos/model/metric.h"
#include "delos/steady/fusion.h"

namespace delos {

/// What must be solved for a metric.
enum class MetricNeed {
  nothing,        ///< coverage: which devices see the target
  pose_block,     ///< the pose's covariance alone
  whole_state,    ///< P∞
  time_constant,  ///< P∞ and the closed loop's slowest pole
};
[[nodiscard]] DELOS_API MetricNeed need_of(const Metric& metric,
                                           const StateLayout& layout);

/// A metric of kLanes pose covariances alone.
/// @param P d×d each, packed as model/lanes.h says
/// @param[out] values kLanes numbers
/// @pre need_of(metric) == MetricNeed::pose_block
DELOS_API void pose_metrics(const Metric& metric, const StateLayout& layout,
                            const double* P, double* values);

/// Any metric but coverage of a state. +∞ where it reads a direction that isn't
/// observed.
[[nodiscard]] DELOS_API double state_metric(const Metric& metric,
                                            const StateLayout& layout,
                                            const FusedState& state,
                                            CovarianceKind kind);

}  // namespace delos
