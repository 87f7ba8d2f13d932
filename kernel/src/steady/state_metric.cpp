#include "delos/steady/state_metric.h"

#include "delos/model/infinity.h"

namespace delos {

double state_metric(const Metric& metric, const StateLayout& layout,
                    const FusedState& state, CovarianceKind kind) {
  if (state.status == RiccatiStatus::iteration_limit) return kInfinity;
  if (row_of(metric.kind).reads == MetricReads::closed_loop) return state.time_constant;
  // An unbounded covariance has a density of zero, which says nothing of the rest: a
  // metric of all states reads every lost direction.
  const auto [first, size] = place_of(metric, layout);
  const StateMatrix& lost = state.unobservable;
  if (lost.cols() > 0 && lost.middleRows(first, size).cwiseAbs().maxCoeff() >= 1e-9)
    return kInfinity;
  return metric_value(metric, layout, state.covariance(kind));
}

}  // namespace delos
