#include "steady/metric_slope.h"

#include <cmath>

#include "delos/model/infinity.h"
#include "delos/model/metric_table.h"
#include "delos/steady/metric_slopes.h"

namespace delos {

std::string slope_problem(const System& system, const Metric& metric) {
  if (!row_of(metric.kind).parts && metric.kind != MetricKind::coverage)
    return metric.name + " has no derivative here";
  return adjoint_problem(system);
}

MetricSlope::MetricSlope(const System& system, const std::vector<Metric>& metrics)
    : solver_(make_smooth_steady_solver(system)),
      metrics_(metrics),
      layout_(system.motion.layout),
      kind_(system.covariance),
      request_(request_for(system, metrics)) {}

bool MetricSlope::reads_state(const double* weights) const {
  for (std::size_t m = 0; m < metrics_.size(); ++m)
    if (row_of(metrics_[m].kind).parts && (!weights || weights[m] != 0)) return true;
  return false;
}

const StateMatrix* MetricSlope::solve(const double* S, Scratch& scratch) const {
  scratch.at.clear();
  scratch.at.add(0, S);
  solver_->solve(scratch.at, request_, scratch.state);
  if (scratch.state.status != RiccatiStatus::converged) return nullptr;
  return &scratch.state.covariance(kind_);
}

void MetricSlope::values(const double* S, Scratch& scratch, double* values) const {
  const StateMatrix* P = reads_state(nullptr) ? solve(S, scratch) : nullptr;
  for (std::size_t m = 0; m < metrics_.size(); ++m) {
    const bool known = P && row_of(metrics_[m].kind).parts;
    values[m] = known ? smooth_metric(metrics_[m], layout_, *P, 0, nullptr) : kInfinity;
    if (!std::isfinite(values[m])) values[m] = kInfinity;
  }
}

void MetricSlope::slope(const double* S, const double* weights, Scratch& scratch,
                        StateMatrix& G) const {
  const StateMatrix* P = reads_state(weights) ? solve(S, scratch) : nullptr;
  if (!P) {
    G.setZero(scratch.at.columns, scratch.at.columns);
    return;
  }
  StateMatrix Y = StateMatrix::Zero(P->rows(), P->cols());
  for (std::size_t m = 0; m < metrics_.size(); ++m) {
    if (weights[m] != 0 && row_of(metrics_[m].kind).parts)
      (void)smooth_metric(metrics_[m], layout_, *P, weights[m], &Y);
  }
  G = solver_->adjoint(scratch.at, Y);
}

}  // namespace delos
