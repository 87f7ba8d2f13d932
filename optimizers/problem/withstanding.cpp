// What objectives are of failures, and of devices that are a little off.
#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "problem/problem_state.h"
#include "problem/worst_case.h"

namespace delos {
namespace {

/// Greatest values are sharper where edges are: s = kSharpness/width, of widths as
/// small as this.
constexpr double kSharpness = 10;
constexpr double kLeastWidth = 0.01;

/// Bytes that layers may take in all, however many draws there are.
constexpr std::size_t kMemory = std::size_t{1} << 30;

double sharpness(double width) { return kSharpness / std::max(width, kLeastWidth); }

}  // namespace

void Problem::State::read_robust() {
  const Robustness& robust = scene().objective.robust;
  const auto& devices = nominal.system.devices;
  if (!robust.failures.empty() && devices.size() < 2)
    throw std::invalid_argument(
        "of a single device none may fail; nothing would be left");
  for (std::size_t i = 0; i < devices.size(); ++i)
    if (std::count(robust.failures.begin(), robust.failures.end(), devices[i].name) > 0)
      failing.push_back(i);
  if (!robust.is_drawn()) return;
  drawn.resize(static_cast<std::size_t>(robust.draws));
  for (int k = 0; k < robust.draws; ++k)
    for (const PlacedDevice& device : devices)
      drawn[static_cast<std::size_t>(k)].deviations.push_back(
          deviation(robust, k, device.name));
}

/// What each draw makes of the system as it was built.
void Problem::State::draw() {
  for (World& world : drawn) {
    world.system = nominal.system;
    for (std::size_t i = 0; i < world.deviations.size(); ++i) {
      PlacedDevice& device = world.system.devices[i];
      device = deviated(device, world.deviations[i]);
    }
  }
}

const InformationLayers& Problem::State::layers(World& world, bool with_guess) {
  std::optional<InformationLayers>& all = world.layers;
  System now = world.system;
  if (!with_guess) now.prior = 0;
  if (all) {
    all->update(now);
  } else {
    all.emplace(
        now, field_poses(samples.samples, scene().orientations),
        LayerOptions{.memory_limit = kMemory / std::max<std::size_t>(drawn.size(), 1),
                     .threads = options.threads});
  }
  return *all;
}

/// The metrics of a system.
/// @param missing a device that fails
FieldValues Problem::State::hard_values(World& world, bool with_guess,
                                        std::optional<std::size_t> missing) {
  FieldValues all;
  for (const AskedMetric& asked : metrics) {
    const Metric& metric = asked.metric;
    const bool with = with_guess && !asked.plain && metric.kind != MetricKind::coverage;
    const InformationLayers& whole = layers(world, with);
    const auto field = [&](const InformationLayers& known) {
      return evaluate_field(known, samples.samples, scene().orientations, metric,
                            field_options());
    };
    all.push_back((missing ? field(whole.without(*missing)) : field(whole)).value);
  }
  return all;
}

/// The worst of all devices and of each failure.
double Problem::State::hard_objective(World& world) {
  double worst = objective(hard_values(world, true), {}, nullptr);
  for (const std::size_t device : failing)
    worst = std::max(worst, objective(hard_values(world, true, device), {}, nullptr));
  return worst;
}

double Problem::State::robust_objective() {
  if (drawn.empty()) return hard_objective(nominal);
  draw();
  std::vector<double> each;
  for (World& world : drawn) each.push_back(hard_objective(world));
  if (scene().objective.robust.combine == DrawRule::worst)
    return *std::max_element(each.begin(), each.end());
  return std::accumulate(each.begin(), each.end(), 0.0) /
         static_cast<double>(each.size());
}

/// The softened worst of all devices and of each failure. Leaves the values of all
/// devices in `values`.
/// @param[out] slope in the unit cube, or null
double Problem::State::soft_objective(std::span<const double> x, const World& world,
                                      double width, double* slope) {
  values = soft->evaluate(world.system, width, failing);
  const auto failures = soft->failure_values();
  std::vector<double> each(1 + failures.size()), share(each.size(), 1.0);
  std::vector<FieldValues> slopes;
  if (slope)
    slopes.assign(each.size(),
                  FieldValues(metrics.size(), std::vector<double>(samples.set.size())));
  for (std::size_t c = 0; c < each.size(); ++c)
    each[c] = objective(c == 0 ? values : failures[c - 1], width,
                        slope ? &slopes[c] : nullptr);
  const double worst =
      failing.empty() ? each[0] : soft_greatest(each, sharpness(width), share.data());
  if (!slope || !std::isfinite(worst)) return worst;
  for (std::size_t c = 0; c < each.size(); ++c)
    for (std::vector<double>& of_metric : slopes[c])
      for (double& value : of_metric) value *= share[c];
  soft->adjoin(slopes[0], std::span<const FieldValues>(slopes).subspan(1));
  chain(x, world, soft->pose_slopes(), slope);
  return worst;
}

double Problem::State::soft_robust_objective(std::span<const double> x, double width,
                                             double* slope) {
  if (drawn.empty()) return soft_objective(x, nominal, width, slope);
  draw();
  const std::size_t n = x.size(), count = drawn.size();
  std::vector<double> each(count), share(count, 1 / static_cast<double>(count)),
      slopes(slope ? count * n : 0);
  for (std::size_t k = 0; k < count; ++k)
    each[k] = soft_objective(x, drawn[k], width, slope ? &slopes[k * n] : nullptr);
  double all = 0;
  if (scene().objective.robust.combine == DrawRule::worst)
    all = soft_greatest(each, sharpness(width), share.data());
  else
    all = std::accumulate(each.begin(), each.end(), 0.0) / static_cast<double>(count);
  for (std::size_t v = 0; slope && v < n; ++v) {
    slope[v] = 0;
    for (std::size_t k = 0; k < count; ++k) slope[v] += share[k] * slopes[k * n + v];
  }
  return all;
}

}  // namespace delos
