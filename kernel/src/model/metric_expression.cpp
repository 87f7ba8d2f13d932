#include "delos/model/metric_expression.h"

#include <algorithm>

#include "delos/model/metric_table.h"
#include "model/trend.h"
#include "model/unit_powers.h"

namespace delos {
namespace {

constexpr const char* kAxes[] = {"x", "y", "z"};

bool has_slope(MetricKind kind) {
  return kind != MetricKind::latency && kind != MetricKind::footprint &&
         kind != MetricKind::nonlinearity && kind != MetricKind::unscented_ratio;
}

/// The names of a formula, and what each of them is.
struct Vocabulary {
  ExpressionNames names;
  std::vector<MetricInput> words;

  explicit Vocabulary(const KnownMetrics& known) {
    for (const std::string& name : metric_names(known)) {
      names.words.push_back(name);
      words.push_back({MetricInput::Kind::metric,
                       std::get<Metric>(parse_metric(name, known)), 0, 0});
    }
    for (int axis = 0; axis < 3; ++axis) {
      names.words.emplace_back(kAxes[axis]);
      words.push_back({MetricInput::Kind::position, {}, axis, 0});
    }
    names.matrix = "P";
    names.indices = known.layout.names();
  }

  [[nodiscard]] MetricInput input(int name) const {
    const int first = static_cast<int>(words.size());
    if (name < first) return words[static_cast<std::size_t>(name)];
    const int n = static_cast<int>(names.indices.size());
    return {MetricInput::Kind::entry, {}, (name - first) / n, (name - first) % n};
  }
};

UnitPowers unit_of_input(const MetricInput& input, const StateLayout& layout) {
  if (input.kind == MetricInput::Kind::metric) return UnitPowers(input.metric.unit);
  if (input.kind == MetricInput::Kind::position)
    return UnitPowers(std::string_view("m"));
  const auto unit = [units = layout.units()](int state) {
    return UnitPowers(units[static_cast<std::size_t>(state)]);
  };
  return unit(input.row) * unit(input.column);
}

Trend trend_of(const MetricInput& input) {
  using Sign = Trend::Sign;
  using Way = Trend::Way;
  switch (input.kind) {
    case MetricInput::Kind::position:
      return {Sign::any, Way::stays};
    case MetricInput::Kind::entry:
      if (input.row != input.column) return {Sign::any, Way::any};
      return {Sign::positive, Way::rises};
    case MetricInput::Kind::metric:
      break;
  }
  const Metric& metric = input.metric;
  if (!has_slope(metric.kind)) return {Sign::positive, Way::any};
  if (metric.expression) return evaluate_metric<Trend>(*metric.expression, trend_of);
  return {Sign::positive, metric.larger_is_better ? Way::falls : Way::rises};
}

}  // namespace

std::variant<Metric, ExpressionProblem> make_metric(std::string_view name,
                                                    std::string_view formula,
                                                    bool larger_is_better,
                                                    std::string_view unit,
                                                    const KnownMetrics& known) {
  const Vocabulary vocabulary(known);
  auto parsed = parse_expression(formula, vocabulary.names);
  if (auto* problem = std::get_if<ExpressionProblem>(&parsed)) return *problem;
  auto expression = std::make_shared<MetricExpression>();
  expression->formula = std::get<Expression>(std::move(parsed));
  for (const int used : expression->formula.names)
    expression->inputs.push_back(vocabulary.input(used));
  if (expression->inputs.empty())
    return ExpressionProblem{0, "is the same everywhere: it reads nothing of a sample"};

  Metric metric{MetricKind::expression, 0, std::string(name), std::string(unit),
                larger_is_better};
  const auto own_unit =
      evaluate_metric<UnitPowers>(*expression, [&](const MetricInput& input) {
        return unit_of_input(input, known.layout);
      }).text();
  if (own_unit) {
    if (!unit.empty() && unit != *own_unit)
      return ExpressionProblem{0,
                               "is in " + *own_unit + ", not in " + std::string(unit)};
    metric.unit = *own_unit;
  } else if (unit.empty()) {
    return ExpressionProblem{
        0,
        "has no unit by itself, since it puts together what has different units; say "
        "in 'unit' what its numbers are in"};
  }
  const Trend trend = evaluate_metric<Trend>(*expression, trend_of);
  metric.monotone =
      trend.way == (larger_is_better ? Trend::Way::falls : Trend::Way::rises) ||
      trend.way == Trend::Way::stays;
  metric.expression = std::move(expression);
  return metric;
}

bool reads(const Metric& metric, MetricKind kind) {
  if (!metric.expression) return metric.kind == kind;
  const auto& inputs = metric.expression->inputs;
  return std::any_of(inputs.begin(), inputs.end(), [kind](const MetricInput& input) {
    return input.kind == MetricInput::Kind::metric && reads(input.metric, kind);
  });
}

bool has_slope(const Metric& metric) {
  if (!metric.expression) return has_slope(metric.kind);
  const auto& inputs = metric.expression->inputs;
  return std::all_of(inputs.begin(), inputs.end(), [](const MetricInput& input) {
    return input.kind != MetricInput::Kind::metric || has_slope(input.metric);
  });
}

bool same_metric(const Metric& a, const Metric& b) {
  if (a.kind != b.kind || a.name != b.name || a.unit != b.unit ||
      a.larger_is_better != b.larger_is_better)
    return false;
  if (!a.expression) return true;
  const auto same_input = [](const MetricInput& p, const MetricInput& q) {
    if (p.kind != q.kind || p.row != q.row || p.column != q.column) return false;
    return p.kind != MetricInput::Kind::metric || same_metric(p.metric, q.metric);
  };
  const auto &of_a = a.expression->inputs, &of_b = b.expression->inputs;
  return a.expression->formula.text == b.expression->formula.text &&
         std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), same_input);
}

}  // namespace delos
