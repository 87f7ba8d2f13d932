#include "delos/steady/state_metric.h"

#include <algorithm>
#include <cmath>

#include "delos/model/infinity.h"
#include "delos/model/lanes.h"
#include "delos/model/metric_expression.h"

namespace delos {
namespace {

double finite_or_infinity(double value) {
  return std::isfinite(value) ? value : kInfinity;
}

/// Whether the rows of P∞ that are read have lost directions, whose variance is
/// infinite.
bool reads_lost(const StateMatrix& lost, int first, int size) {
  return lost.cols() > 0 && lost.middleRows(first, size).cwiseAbs().maxCoeff() >= 1e-9;
}

}  // namespace

double state_metric(const Metric& metric, const StateLayout& layout,
                    const FusedState& state, CovarianceKind kind,
                    const PoseFacts& facts) {
  if (metric.kind == MetricKind::coverage) return facts.seen;
  if (metric.kind == MetricKind::footprint) return facts.footprint;
  if (metric.expression) {
    // What isn't known of a part isn't known of the whole: 1/∞ isn't 0.
    bool known = true;
    const auto value = [&](const MetricInput& input) {
      double part = kInfinity;
      if (input.kind == MetricInput::Kind::metric) {
        part = state_metric(input.metric, layout, state, kind, facts);
      } else if (input.kind == MetricInput::Kind::position) {
        part = facts.p(input.row);
      } else if (state.status != RiccatiStatus::iteration_limit &&
                 !reads_lost(state.unobservable, input.row, 1) &&
                 !reads_lost(state.unobservable, input.column, 1)) {
        part = state.covariance(kind)(input.row, input.column);
      }
      known = known && std::isfinite(part);
      return part;
    };
    const double all = evaluate_metric<double>(*metric.expression, value);
    return known ? finite_or_infinity(all) : kInfinity;
  }
  if (state.status == RiccatiStatus::iteration_limit) return kInfinity;
  if (row_of(metric.kind).reads == MetricReads::closed_loop) return state.time_constant;
  // An unbounded covariance has a density of zero, which says nothing of the rest: a
  // metric of all states reads every lost direction.
  const auto [first, size] = place_of(metric, layout);
  if (reads_lost(state.unobservable, first, size)) return kInfinity;
  if (metric.kind == MetricKind::nonlinearity) return facts.nonlinearity;
  if (metric.kind == MetricKind::unscented_ratio) return facts.unscented_ratio;
  return metric_value(metric, layout, state.covariance(kind));
}

void lane_metrics(const Metric& metric, const StateLayout& layout, const double* P,
                  const PoseFacts* facts, double* values) {
  if (metric.kind == MetricKind::coverage || metric.kind == MetricKind::footprint) {
    const auto fact =
        metric.kind == MetricKind::coverage ? &PoseFacts::seen : &PoseFacts::footprint;
    for (int l = 0; l < kLanes; ++l) values[l] = facts[l].*fact;
    return;
  }
  if (!metric.expression) return metric_values(metric, layout, P, values);

  const auto& inputs = metric.expression->inputs;
  double parts[kMostNames][kLanes];
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const MetricInput& input = inputs[i];
    switch (input.kind) {
      case MetricInput::Kind::metric:
        lane_metrics(input.metric, layout, P, facts, parts[i]);
        break;
      case MetricInput::Kind::entry:
        std::copy_n(P + packed_index(std::max(input.row, input.column),
                                     std::min(input.row, input.column)) *
                            kLanes,
                    kLanes, parts[i]);
        break;
      case MetricInput::Kind::position:
        for (int l = 0; l < kLanes; ++l) parts[i][l] = facts[l].p(input.row);
        break;
    }
  }
  for (int l = 0; l < kLanes; ++l) {
    double of_lane[kMostNames];
    bool known = true;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      of_lane[i] = parts[i][l];
      known = known && std::isfinite(of_lane[i]);
    }
    const double all = evaluate(metric.expression->formula, of_lane);
    values[l] = known ? finite_or_infinity(all) : kInfinity;
  }
}

}  // namespace delos
