#include "steady/metric_slope.h"

#include <cmath>

#include "delos/expression/dual.h"
#include "delos/model/infinity.h"
#include "delos/model/metric_expression.h"
#include "delos/model/metric_table.h"
#include "delos/steady/metric_slopes.h"

namespace delos {

std::string slope_problem(const System& system, const Metric& metric) {
  if (!has_slope(metric)) return metric.name + " has no derivative here";
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
    if (need_of(metrics_[m], layout_) != MetricNeed::nothing &&
        (!weights || weights[m] != 0))
      return true;
  return false;
}

const StateMatrix* MetricSlope::solve(const double* S, Scratch& scratch) const {
  scratch.at.clear();
  scratch.at.add(0, S);
  solver_->solve(scratch.at, request_, scratch.state);
  if (scratch.state.status != RiccatiStatus::converged) return nullptr;
  return &scratch.state.covariance(kind_);
}

double MetricSlope::value(const Metric& metric, const StateMatrix* P,
                          const PoseFacts& facts) const {
  if (metric.kind == MetricKind::coverage) return facts.seen;
  if (!metric.expression)
    return P && row_of(metric.kind).parts
               ? smooth_metric(metric, layout_, *P, 0, nullptr)
               : kInfinity;
  bool known = true;
  const double all =
      evaluate_metric<double>(*metric.expression, [&](const MetricInput& input) {
        const double part = input_value(input, P, facts);
        known = known && std::isfinite(part);
        return part;
      });
  return known ? all : kInfinity;
}

double MetricSlope::input_value(const MetricInput& input, const StateMatrix* P,
                                const PoseFacts& facts) const {
  switch (input.kind) {
    case MetricInput::Kind::metric:
      return value(input.metric, P, facts);
    case MetricInput::Kind::entry:
      return P ? (*P)(input.row, input.column) : kInfinity;
    case MetricInput::Kind::position:
      break;
  }
  return facts.p(input.row);
}

// ∂e/∂P = Σ_i ∂e/∂v_i ∂v_i/∂P over what the formula reads; an entry off the diagonal
// stands in P twice.
void MetricSlope::add_slope(const Metric& metric, const StateMatrix* P,
                            const PoseFacts& facts, double weight, StateMatrix& Y,
                            double& g) const {
  if (metric.kind == MetricKind::coverage) {
    g += weight;
    return;
  }
  if (!metric.expression) {
    if (P) (void)smooth_metric(metric, layout_, *P, weight, &Y);
    return;
  }
  const MetricExpression& expression = *metric.expression;
  Dual<double, 1> values[kMostNames];
  for (std::size_t i = 0; i < expression.inputs.size(); ++i) {
    values[i] = input_value(expression.inputs[i], P, facts);
    if (!std::isfinite(values[i].value)) return;  // nothing is known of the whole
  }
  for (std::size_t i = 0; i < expression.inputs.size(); ++i) {
    const MetricInput& input = expression.inputs[i];
    if (input.kind == MetricInput::Kind::position) continue;
    values[i].slope[0] = 1;
    const double part = weight * evaluate(expression.formula, values).slope[0];
    values[i].slope[0] = 0;
    if (part == 0 || !std::isfinite(part)) continue;
    if (input.kind == MetricInput::Kind::metric) {
      add_slope(input.metric, P, facts, part, Y, g);
    } else {
      Y(input.row, input.column) += part / 2;
      Y(input.column, input.row) += part / 2;
    }
  }
}

void MetricSlope::values(const double* S, const PoseFacts& facts, Scratch& scratch,
                         double* values) const {
  const StateMatrix* P = reads_state(nullptr) ? solve(S, scratch) : nullptr;
  for (std::size_t m = 0; m < metrics_.size(); ++m) {
    values[m] = value(metrics_[m], P, facts);
    if (!std::isfinite(values[m])) values[m] = kInfinity;
  }
}

double MetricSlope::slope(const double* S, const PoseFacts& facts,
                          const double* weights, Scratch& scratch,
                          StateMatrix& G) const {
  const StateMatrix* P = reads_state(weights) ? solve(S, scratch) : nullptr;
  StateMatrix Y;
  if (P) Y = StateMatrix::Zero(P->rows(), P->cols());
  double g = 0;
  for (std::size_t m = 0; m < metrics_.size(); ++m)
    if (weights[m] != 0) add_slope(metrics_[m], P, facts, weights[m], Y, g);
  if (P)
    G = solver_->adjoint(scratch.at, Y);
  else
    G.setZero(scratch.at.columns, scratch.at.columns);
  return g;
}

}  // namespace delos
