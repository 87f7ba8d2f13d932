#include "session/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "delos/scene/number.h"
#include "session/difference.h"
#include "session/refusal.h"

namespace delos::session {
namespace {

/// Of the number's size: the error of a central difference is of its square.
constexpr double kStep = 1e-5;
/// Of the change over the step, and of the value: what the values in the middle and at
/// the ends may be off one line by, where the metric is smooth.
constexpr double kBend = 0.1, kRounding = 1e-9;

SceneNumber found_number(Scene& scene, const std::string& path,
                         PluginRegistry& plugins) {
  const auto found = find_number(scene, path, plugins);
  if (const auto* problem = std::get_if<std::string>(&found))
    throw Refusal(Blame::question, "sensitivity: " + *problem);
  return std::get<SceneNumber>(found);
}

/// The scene with its number at another value, over the samples of the first.
Field field_with(const LoadedScene& loaded, const std::string& path, double value,
                 const Samples& samples, const FieldOptions& options,
                 PluginRegistry& plugins) {
  Scene scene = loaded.scene;
  *found_number(scene, path, plugins).value = value;
  const LoadedScene other = loaded_from(std::move(scene), plugins, &loaded.system);
  return evaluate_field(other.system, samples, other.scene.orientations, loaded.metric,
                        options);
}

/// Where the metric jumps within the step it has no slope: a device begins or ends to
/// see. @returns how many samples that are
std::size_t leave_out_edges(Field& before, const Field& middle, Field& after) {
  std::size_t edges = 0;
  for (std::size_t i = 0; i < middle.value.size(); ++i) {
    const double low = before.value[i], high = after.value[i];
    if (!std::isfinite(low) || !std::isfinite(high)) continue;
    const double bend = std::abs(low + high - 2 * middle.value[i]);
    if (bend <= kBend * std::abs(high - low) + kRounding * std::abs(middle.value[i]))
      continue;
    before.value[i] = after.value[i] = std::numeric_limits<double>::infinity();
    ++edges;
  }
  return edges;
}

std::string slope_unit(const std::string& of, const std::string& per) {
  if (per == "1") return of;
  return of == per ? "1" : of + "/(" + per + ")";
}

}  // namespace

Sensitivity draw_sensitivity(const LoadedScene& loaded, const std::string& path,
                             std::size_t most, const FieldOptions& options,
                             PluginRegistry& plugins) {
  Scene scene = loaded.scene;
  const SceneNumber known = found_number(scene, path, plugins);
  Sensitivity result;
  result.value = *known.value;
  result.unit = known.unit;
  const bool placed = known.unit == "m" || known.unit == "rad";
  const double size = std::abs(result.value);
  const bool within_one = placed && known.scale == ParamScale::linear;
  const double step = kStep * (within_one ? std::max(size, 1.0) : size > 0 ? size : 1);
  result.least = std::max(known.lower, result.value - step);
  result.most = std::min(known.upper, result.value + step);
  if (!(result.most > result.least))
    throw Refusal(Blame::question, "sensitivity: " + path + " can have one value only");

  bool coarse = false;
  const Samples samples = drawn_samples(loaded.scene, most, coarse);
  const auto field_at = [&](double value) {
    return field_with(loaded, path, value, samples, options, plugins);
  };
  Field before = field_at(result.least), after = field_at(result.most);
  const Field middle = field_at((result.least + result.most) / 2);
  const std::size_t edges = leave_out_edges(before, middle, after);
  result.drawn = drawn_change(before, after, 1 / (result.most - result.least));
  result.drawn.coarse = coarse;
  result.drawn.field.metric = loaded.metric.name + " per " + path;
  result.drawn.field.unit = slope_unit(loaded.metric.unit, known.unit);
  result.drawn.summary["metric"] = {{"name", result.drawn.field.metric},
                                    {"unit", result.drawn.field.unit}};
  result.drawn.summary["sensitivity"] = {{"path", path},
                                         {"value", number(result.value)},
                                         {"unit", result.unit},
                                         {"edges", edges}};
  return result;
}

}  // namespace delos::session
