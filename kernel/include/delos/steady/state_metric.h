// Metrics of a steady state. Equations: Allen (2007), §4.3.
#pragma once

#include <Eigen/Core>

#include "delos/api.h"
#include "delos/model/metric_table.h"
#include "delos/steady/fused_state.h"

namespace delos {

/// What metrics may read of a pose besides its steady state.
struct PoseFacts {
  double seen = 0;       ///< how many devices see the target
  double footprint = 0;  ///< the least of theirs, metres; +∞: none has pixels
  Eigen::Vector3d p = Eigen::Vector3d::Zero();   ///< where it is, in W, metres
  double nonlinearity = 0, unscented_ratio = 1;  ///< of their metrics
};

/// Any metric of a state. +∞ where it reads a direction that isn't observed, and where
/// its formula has no finite value.
[[nodiscard]] DELOS_API double state_metric(const Metric& metric,
                                            const StateLayout& layout,
                                            const FusedState& state,
                                            CovarianceKind kind,
                                            const PoseFacts& facts);

/// Any metric of kLanes pose covariances side by side, bit for bit as state_metric().
/// @param P d×d each, packed as model/lanes.h says
/// @param facts of each lane
/// @param[out] values kLanes numbers
/// @pre need_of(metric) is at most MetricNeed::pose_block
DELOS_API void lane_metrics(const Metric& metric, const StateLayout& layout,
                            const double* P, const PoseFacts* facts, double* values);

}  // namespace delos
