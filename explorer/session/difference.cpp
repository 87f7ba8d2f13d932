#include "session/difference.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "delos/scene/definition.h"
#include "session/comparison.h"

namespace delos::session {
namespace {

/// A metric of what was pinned over samples, evaluated only where they, the metric or
/// the definition are others than the last time.
/// @param pinned the baseline, evaluated as the design is
const Field& field_of(const LoadedScene& pinned, const Metric& metric,
                      const Samples& samples, const FieldOptions& options,
                      std::optional<Field>& kept) {
  if (kept && !kept->cancelled && kept->metric == metric.name &&
      kept->definition == definition_of(pinned.system) &&
      kept->samples.points == samples.points)
    return *kept;
  const std::string problem = metric_problem(pinned.system, metric);
  if (!problem.empty())
    throw std::invalid_argument("what was pinned can't be compared: " + problem);
  kept = evaluate_field(pinned.system, samples, pinned.scene.orientations, metric,
                        options);
  return *kept;
}

Drawn change_of(double before, double after, bool inside) {
  if (inside) return Drawn::inside;
  const bool was = std::isfinite(before), is = std::isfinite(after);
  if (was && is) return Drawn::value;
  return is ? Drawn::gained : was ? Drawn::lost : Drawn::blind;
}

Json extreme_json(const Extreme& extreme, std::size_t common) {
  if (common == 0) return {};
  return {{"value", number(extreme.value)}, {"at", numbers(extreme.at)}};
}

}  // namespace

DrawnField drawn_change(const Field& before, const Field& after, double factor) {
  DrawnField drawn;
  Comparison comparison = compare_fields(before, after);
  for (std::size_t i = 0; i < after.value.size(); ++i) {
    const bool inside = (!after.inside.empty() && after.inside[i] != 0) ||
                        (!before.inside.empty() && before.inside[i] != 0);
    drawn.mask.push_back(change_of(before.value[i], after.value[i], inside));
  }
  drawn.field = std::move(comparison.difference);
  drawn.field.larger_is_better = after.larger_is_better;
  for (double& value : drawn.field.value) value *= factor;
  const auto count = [&](Drawn what) {
    return static_cast<std::size_t>(
        std::count(drawn.mask.begin(), drawn.mask.end(), what));
  };
  const std::size_t counted = drawn.mask.size() - count(Drawn::inside);
  const FieldStatistics extremes = summarize(drawn.field);
  drawn.summary = {
      {"metric", {{"name", after.metric}, {"unit", after.unit}}},
      {"samples", counted},
      {"finite", comparison.common},
      {"mean", comparison.common > 0 ? number(factor * comparison.mean) : Json()},
      {"min", extreme_json(extremes.min, comparison.common)},
      {"max", extreme_json(extremes.max, comparison.common)},
      {"better", number(comparison.improved_fraction)},
      {"gained", count(Drawn::gained)},
      {"lost", count(Drawn::lost)}};
  return drawn;
}

DrawnField draw_difference(const LoadedScene& loaded, Baseline& baseline,
                           std::size_t most, const FieldOptions& options) {
  bool coarse = false;
  const Samples samples = drawn_samples(loaded.scene, most, coarse);
  DrawnField drawn = draw_difference_on(loaded, baseline, samples, options);
  drawn.coarse = coarse;
  return drawn;
}

DrawnField draw_difference_on(const LoadedScene& loaded, Baseline& baseline,
                              const Samples& samples, const FieldOptions& options) {
  std::vector<LoadedScene> sides{baseline.loaded, loaded};
  evaluate_alike(sides);
  const Field& before =
      field_of(sides[0], loaded.metric, samples, options, baseline.field);
  const Field after = evaluate_field(sides[1].system, samples,
                                     loaded.scene.orientations, loaded.metric, options);
  DrawnField drawn = drawn_change(before, after);
  drawn.summary["definition"] = to_string(after.definition);
  drawn.summary["pinned_definition"] = alike(before.definition, after.definition)
                                           ? Json()
                                           : Json(to_string(before.definition));
  return drawn;
}

}  // namespace delos::session
