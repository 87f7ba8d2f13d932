// Metrics of a steady state. Equations: Allen (2007), §4.3.
#pragma once

#include "delos/api.h"
#include "delos/model/metric_table.h"
#include "delos/steady/fused_state.h"

namespace delos {

/// Any metric but coverage of a state. +∞ where it reads a direction that isn't
/// observed.
[[nodiscard]] DELOS_API double state_metric(const Metric& metric,
                                            const StateLayout& layout,
                                            const FusedState& state,
                                            CovarianceKind kind);

}  // namespace delos
