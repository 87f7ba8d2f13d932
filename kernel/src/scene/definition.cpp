#include "delos/scene/definition.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "delos/model/metric_expression.h"
#include "delos/text/format.h"
#include "delos/text/units.h"

namespace delos {
namespace {

/// What sets a rate: factor·variable + offset; without a variable, offset alone. With a
/// timing, that is of the exposure which sets it.
struct RateSource {
  const VariableEntry* variable = nullptr;
  double factor = 0, offset = 0;
  std::optional<Timing> timing = {};
  friend bool operator==(const RateSource&, const RateSource&) = default;
};

/// The device of "devices.NAME" and a last part such as ".rate", else empty.
std::string device_of(const std::string& path, const std::string& last) {
  const std::string first = "devices.";
  if (!path.starts_with(first) || !path.ends_with(last) ||
      path.size() <= first.size() + last.size())
    return "";
  return path.substr(first.size(), path.size() - first.size() - last.size());
}

/// The devices whose rates variables set.
std::map<std::string, RateSource> varied_rates(const Scene& scene) {
  std::map<std::string, RateSource> varied;
  const auto timing_of = [&](const std::string& name) -> std::optional<Timing> {
    for (const DeviceEntry& device : scene.devices)
      if (device.name == name) return device.timing;
    return std::nullopt;
  };
  const auto add = [&](const std::string& path, RateSource source) {
    if (const std::string name = device_of(path, ".rate"); !name.empty())
      varied[name] = source;
    const std::string exposed = device_of(path, ".exposure");
    source.timing = timing_of(exposed);
    if (source.timing) varied[exposed] = source;
  };
  for (const VariableEntry& v : scene.variables) {
    add(v.path, {&v, 1, 0});
    for (const Follower& f : v.followers) add(f.path, {&v, f.factor, f.offset});
  }
  return varied;
}

Fusion default_fusion(const Scene& scene) {
  const bool one = !scene.motion.in_continuous_time() || has_one_rate(scene);
  return one ? Fusion::stacked : Fusion::continuous;
}

/// Whether a scene can have this fusion.
bool takes(const Scene& scene, Fusion fusion) {
  const bool exposes = std::any_of(scene.devices.begin(), scene.devices.end(),
                                   [](const DeviceEntry& d) { return d.exposure > 0; });
  if (exposes && !exposure_problem(scene.motion, {fusion, scene.covariance}).empty())
    return false;
  const bool has_free_clock = std::any_of(
      scene.devices.begin(), scene.devices.end(), [&](const DeviceEntry& d) {
        return !d.clock.empty() && !clock_entry(scene, d.clock);
      });
  if (has_free_clock && !free_clock_problem({fusion, scene.covariance}).empty())
    return false;
  if (scene.lag > 0 && !lag_problem(scene.motion, {fusion, scene.covariance}).empty())
    return false;
  if (!calibration_problem(scene.motion, {fusion, scene.covariance, 0, scene.error})
           .empty() &&
      has_constant_errors(scene))
    return false;
  if (fusion == Fusion::stacked) return has_one_rate(scene);
  return scene.motion.in_continuous_time() ||
         (fusion != Fusion::continuous && fusion != Fusion::periodic);
}

/// A state for each clock, in the order of the devices.
std::vector<std::string> clock_states(const Scene& scene) {
  std::vector<std::string> states;
  for (const DeviceEntry& device : scene.devices) {
    const std::string state = clock_state(device);
    if (!state.empty() &&
        std::find(states.begin(), states.end(), state) == states.end())
      states.push_back(state);
  }
  return states;
}

}  // namespace

std::string clock_state(const DeviceEntry& device) {
  return device.clock.empty() ? "" : "clock_" + device.clock;
}

const ClockEntry* clock_entry(const Scene& scene, const std::string& clock) {
  const auto entry =
      std::find_if(scene.clocks.begin(), scene.clocks.end(),
                   [&](const ClockEntry& known) { return known.name == clock; });
  return entry == scene.clocks.end() ? nullptr : &*entry;
}

bool shares_error(const CommonError& common, const DeviceEntry& device) {
  if (device.mount != Mount::world) return false;
  if (!common.devices.empty())
    return std::find(common.devices.begin(), common.devices.end(), device.name) !=
           common.devices.end();
  return common.group.empty() || device.group == common.group;
}

bool has_constant_errors(const Scene& scene) {
  return !scene.common_errors.empty() ||
         std::any_of(scene.devices.begin(), scene.devices.end(),
                     [](const DeviceEntry& d) {
                       return !d.calibration.exact() || d.without_sight.bias != 0;
                     });
}

std::string free_clock_problem(const Definition& definition) {
  if (definition.covariance == CovarianceKind::single) return "";
  std::string problem = "is unknown anew at each update, ";
  switch (definition.fusion) {
    case Fusion::stacked:
    case Fusion::periodic:
      return "";
    case Fusion::continuous:
      problem += "but continuous fusion has no updates";
      break;
    case Fusion::sequential:
      problem += "but sequential fusion has one reading in each, which says nothing so";
      break;
    case Fusion::artemis:
      problem += "which artemis fusion can't have";
      break;
  }
  return problem +
         "; use fusion: stacked or periodic, or say in 'clocks' how it drifts";
}

StateLayout covariance_layout(const Scene& scene) {
  if (scene.covariance != CovarianceKind::single) return scene.motion.layout;
  return {scene.motion.layout.pose, 1, clock_states(scene)};
}

KnownMetrics known_metrics(const Scene& scene) {
  KnownMetrics known{covariance_layout(scene)};
  for (const MetricEntry& entry : scene.metrics) {
    auto made = make_metric(entry.name, entry.expression, entry.larger_is_better,
                            entry.unit, known);
    // What can't be made has a finding where the scene is read.
    if (auto* metric = std::get_if<Metric>(&made))
      known.own.push_back(std::move(*metric));
  }
  return known;
}

namespace {

/// What is said of the errors of calibration, where devices have any.
std::string error_words(const Definition& definition) {
  if (!definition.error) return "";
  switch (*definition.error) {
    case ErrorPart::total:
      return ", scatter and calibration";
    case ErrorPart::scatter:
      return ", scatter alone";
    case ErrorPart::bias:
      break;
  }
  return ", errors of calibration alone";
}

}  // namespace

std::string to_string(const Definition& definition) {
  if (definition.covariance == CovarianceKind::single)
    return "covariance of a single reading" + error_words(definition);
  const std::string kind =
      definition.covariance == CovarianceKind::prior ? "a-priori" : "a-posteriori";
  const std::string later =
      definition.lag > 0 ? ' ' + format_quantity(definition.lag, "s") + " later" : "";
  return kind + " covariance" + later + ", " + to_string(definition.fusion) +
         " fusion" + error_words(definition);
}

bool alike(const Definition& a, const Definition& b) {
  // Where no device is in doubt, there is scatter alone.
  if (a.error && b.error && a.error != b.error) return false;
  if (a.error.value_or(ErrorPart::scatter) == ErrorPart::bias ||
      b.error.value_or(ErrorPart::scatter) == ErrorPart::bias)
    return a.error == b.error;
  if (a.covariance == CovarianceKind::single || b.covariance == CovarianceKind::single)
    return a.covariance == b.covariance;
  const bool one_covariance =
      a.fusion == Fusion::continuous || a.fusion == Fusion::periodic;
  return a.fusion == b.fusion && a.lag == b.lag &&
         (one_covariance || a.covariance == b.covariance);
}

bool varies_exposures(const Scene& scene) {
  const auto is_one = [&](const std::string& path) {
    return std::any_of(scene.devices.begin(), scene.devices.end(),
                       [&](const DeviceEntry& device) {
                         return path == "devices." + device.name + ".exposure";
                       });
  };
  return std::any_of(
      scene.variables.begin(), scene.variables.end(), [&](const VariableEntry& v) {
        return is_one(v.path) ||
               std::any_of(v.followers.begin(), v.followers.end(),
                           [&](const Follower& f) { return is_one(f.path); });
      });
}

bool varies_rates(const Scene& scene) { return !varied_rates(scene).empty(); }

bool has_one_rate(const Scene& scene) {
  const std::map<std::string, RateSource> varied = varied_rates(scene);
  const auto source = [&](const DeviceEntry& device) {
    const auto found = varied.find(device.name);
    return found == varied.end() ? RateSource{nullptr, 0, rate_of(device)}
                                 : found->second;
  };
  return std::all_of(scene.devices.begin(), scene.devices.end(),
                     [&](const DeviceEntry& device) {
                       return source(device) == source(scene.devices.front());
                     });
}

std::string exposure_problem(const DeviceEntry& device) {
  const double period = 1 / rate_of(device);
  // 16.6667 ms are as long as 1/60 s to whoever writes them so.
  if (device.exposure <= period * (1 + 1e-5)) return "";
  return "must not be longer than the time between updates, " +
         shortest(1000 * period) + " ms at " + shortest(rate_of(device)) + " Hz";
}

double rate_of(const DeviceEntry& device) {
  return device.timing ? 1 / period_of(*device.timing, device.exposure) : device.rate;
}

std::string noise_problem(const DeviceEntry& device) {
  if (!device.noise_over_time) return "";
  const double ratio = noise_ratio(*device.noise_over_time, device.exposure);
  if (std::isfinite(ratio) && ratio > 0) return "";
  return "of " + shortest(1000 * device.exposure) +
         " ms leaves its noise_over_time no finite value above 0; make it longer";
}

std::string lag_problem(const MotionModel& motion, const Definition& definition) {
  if (definition.covariance == CovarianceKind::single)
    return "isn't known to single readings, which say nothing of how the target moves; "
           "leave it out, or use covariance: prior or posterior";
  if (!motion.in_continuous_time())
    return "needs a motion in continuous time, but custom motion says nothing of what "
           "happens between updates";
  if (definition.fusion == Fusion::artemis)
    return "isn't known to artemis fusion, whose sum of Ψ is no filter's; use fusion: "
           "stacked, continuous, periodic or sequential";
  return "";
}

std::string calibration_problem(const MotionModel& motion,
                                const Definition& definition) {
  if (!definition.error || *definition.error == ErrorPart::scatter) return "";
  const std::string instead = "; use fusion: stacked or continuous, or error: scatter";
  switch (definition.fusion) {
    case Fusion::stacked:
      return "";
    case Fusion::continuous:
      if (motion.is_chain()) return "";
      return "is of position, position_velocity and position_velocity_acceleration "
             "motion under continuous fusion" +
             instead;
    case Fusion::periodic:
    case Fusion::sequential:
      return "shifts an estimate to and fro where devices report by turns, which isn't "
             "solved for" +
             instead;
    case Fusion::artemis:
      break;
  }
  return "isn't known to artemis fusion, which is no filter's" + instead;
}

std::string exposure_problem(const MotionModel& motion, const Definition& definition) {
  if (definition.covariance == CovarianceKind::single)
    return "isn't known to single readings, which are of one instant; leave it out, or "
           "use covariance: prior or posterior";
  if (!motion.in_continuous_time())
    return "needs a motion in continuous time, but custom motion says nothing of what "
           "happens between updates";
  if (!motion.is_chain())
    return "is of position, position_velocity and position_velocity_acceleration "
           "motion, not of one by matrices";
  if (definition.fusion == Fusion::continuous)
    return "isn't known to continuous fusion, the limit of frequent updates, in which "
           "no reading takes time; use fusion: periodic, or sequential";
  if (definition.fusion == Fusion::artemis)
    return "isn't known to artemis fusion; use fusion: stacked, periodic or sequential";
  return "";
}

Definition definition_of(const Scene& scene) {
  const auto error =
      has_constant_errors(scene) ? std::optional(scene.error) : std::nullopt;
  if (scene.covariance == CovarianceKind::single)
    return {Fusion::stacked, CovarianceKind::single, scene.lag, error};
  return {scene.fusion.value_or(default_fusion(scene)), scene.covariance, scene.lag,
          error};
}

Scene with_definition(Scene scene) {
  if (scene.covariance != CovarianceKind::single)
    scene.fusion = definition_of(scene).fusion;
  return scene;
}

std::optional<Fusion> common_fusion(std::span<const Scene* const> scenes) {
  std::optional<Fusion> common;
  bool stacked = true;
  for (const Scene* scene : scenes) {
    const Fusion own = default_fusion(*scene), said = scene->fusion.value_or(own);
    stacked = stacked && own == Fusion::stacked;
    if (said == own) continue;
    if (common && *common != said) return std::nullopt;
    common = said;
  }
  if (!common) common = stacked ? Fusion::stacked : Fusion::continuous;
  const bool all = std::all_of(scenes.begin(), scenes.end(), [&](const Scene* scene) {
    return takes(*scene, *common);
  });
  return all ? common : std::nullopt;
}

}  // namespace delos
