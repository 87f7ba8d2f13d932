// Metrics that a scene makes of others by a formula.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "delos/expression/expression.h"
#include "delos/model/metric.h"

namespace delos {

/// What a formula reads at a pose.
struct MetricInput {
  enum class Kind {
    metric,    ///< another metric
    entry,     ///< P[row, column]
    position,  ///< a coordinate of the sample: `row` is the axis
  };
  Kind kind = Kind::metric;
  Metric metric;
  int row = 0, column = 0;
};

/// The formula of a metric.
struct MetricExpression {
  Expression formula;
  std::vector<MetricInput> inputs;  ///< one a name that the formula uses, in that order
};

/// Values of the names that a metric's formula uses, whatever they are.
template <class T, class Value>
[[nodiscard]] T evaluate_metric(const MetricExpression& expression, Value&& value) {
  T inputs[kMostNames];
  for (std::size_t i = 0; i < expression.inputs.size(); ++i)
    inputs[i] = value(expression.inputs[i]);
  return evaluate(expression.formula, inputs);
}

/// A metric by a formula of what is known: names of metrics, entries P[x, y] of P∞ by
/// the names of states, and x, y, z, the sample's place.
///
/// Its unit follows from those of what it reads, a bare number fitting any, and
/// Metric::monotone from the signs: σ_z/σ_x isn't, √(σ_x² + 2σ_z²) is.
/// @param unit of the result, where the formula leaves it open: adds metres to radians
/// @returns it, or what is wrong and where in `formula`
[[nodiscard]] DELOS_API std::variant<Metric, ExpressionProblem> make_metric(
    std::string_view name, std::string_view formula, bool larger_is_better,
    std::string_view unit, const KnownMetrics& known);

/// Whether a metric is of this kind, or its formula reads one that is.
[[nodiscard]] DELOS_API bool reads(const Metric& metric, MetricKind kind);

/// Whether a metric is a smooth function of P∞ and of nothing else that moves.
[[nodiscard]] DELOS_API bool has_slope(const Metric& metric);

/// Whether two scenes mean the same by a metric: a name may stand for two formulas.
[[nodiscard]] DELOS_API bool same_metric(const Metric& a, const Metric& b);

}  // namespace delos
