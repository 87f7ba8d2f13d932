#include "delos/rig/system.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "delos/device/faults.h"
#include "delos/model/infinity.h"
#include "delos/plugin/registry.h"
#include "delos/scene/clutter.h"
#include "delos/scene/definition.h"
#include "rig/parts.h"

namespace delos {
namespace {

std::shared_ptr<const Device> reuse(const System* previous, std::size_t index,
                                    const DeviceEntry& entry) {
  if (!previous || index >= previous->devices.size()) return nullptr;
  const PlacedDevice& old = previous->devices[index];
  return old.type == entry.type && old.params == entry.params ? old.device : nullptr;
}

/// The index of the beacons that a device sees.
std::shared_ptr<const BeaconIndex> beacons_of(const Scene& scene,
                                              const DeviceEntry& entry) {
  std::vector<Beacon> all;
  for (const std::size_t set : seen_sets(scene.beacons, entry.beacons)) {
    const std::vector<Beacon> lit = lit_beacons(scene.beacons[set]);
    all.insert(all.end(), lit.begin(), lit.end());
  }
  return std::make_shared<const BeaconIndex>(std::move(all));
}

/// The same, shared with the previous system and with devices of the same sets.
class BeaconSharing {
 public:
  BeaconSharing(const Scene& scene, const System* previous)
      : scene_(scene),
        previous_(previous && previous->beacon_sets == scene.beacons ? previous
                                                                     : nullptr) {}

  std::shared_ptr<const BeaconIndex> operator()(std::size_t index,
                                                const DeviceEntry& entry) {
    if (previous_ && index < previous_->devices.size()) {
      const PlacedDevice& old = previous_->devices[index];
      const TargetMount* carried = old.carried();
      if (carried && carried->sees == entry.beacons) return carried->beacons;
    }
    auto& made = made_[entry.beacons];
    if (!made) made = beacons_of(scene_, entry);
    return made;
  }

 private:
  const Scene& scene_;
  const System* previous_;
  std::map<std::vector<std::string>, std::shared_ptr<const BeaconIndex>> made_;
};

/// The bodies of one mount, placed.
Occluders placed_occluders(const std::vector<OccluderEntry>& occluders, Mount mount) {
  const std::vector<TriangleMesh> bodies = placed_bodies(occluders, mount);
  std::vector<char> rooms;
  for (const OccluderEntry& entry : occluders)
    if (entry.mount == mount) rooms.push_back(entry.room);
  return bodies.empty() ? Occluders() : Occluders(bodies, rooms);
}

/// What makes single readings of a system, exactly to rounding: the posterior of a
/// random walk that nothing is known of before an update,
///
///     (P⁻¹ + S)⁻¹ → S⁻¹ = (Hᵀ R⁻¹ H)⁻¹,   P ≥ q dt → ∞
///
/// since the closed forms of the scalar chain lose nothing at large ρ = q dt λ.
constexpr double kUnknown = 1e20;  // q, m²/s and rad²/s; dt is 1 s

MotionModel no_motion(const StateLayout& layout) {
  const int d = layout.coordinates(), n = layout.size();
  if (n == d) return {layout, ChainMotion{kUnknown * CoordinateMatrix::Identity(d, d)}};
  return {layout, CustomMotion{StateMatrix::Identity(n, n),
                               kUnknown * StateMatrix::Identity(n, n)}};
}

/// @throws Unbuildable it isn't over by the next update
double exposure_of(const DeviceEntry& entry) {
  if (const std::string problem = exposure_problem(entry); !problem.empty())
    throw Unbuildable(entry.name + ": exposure " + problem);
  return std::min(entry.exposure, 1 / rate_of(entry));
}

/// How many times what its parameters say the covariance of its noise is.
/// @throws Unbuildable the sample time leaves it no finite one
double noise_of(const DeviceEntry& entry) {
  if (const std::string problem = noise_problem(entry); !problem.empty())
    throw Unbuildable(entry.name + ": exposure " + problem);
  return entry.noise_over_time ? noise_ratio(*entry.noise_over_time, entry.exposure)
                               : 1;
}

/// Which state of a layout has this name.
std::optional<int> state_named(const StateLayout& layout, const std::string& name) {
  const std::vector<std::string> names = layout.names();
  const auto at = std::find(names.begin(), names.end(), name);
  if (name.empty() || at == names.end()) return std::nullopt;
  return static_cast<int>(at - names.begin());
}

/// Behind all others, the states of a device's own.
StateBlock add_states(const std::string& device, const std::vector<OwnState>& states,
                      MotionModel& motion) {
  if (states.empty()) return {};
  StateLayout& layout = motion.layout;
  const StateBlock range{layout.size(), static_cast<int>(states.size())};
  if (range.first + range.size > kMaxState)
    throw Unbuildable("with " + device + "'s own states the filter has more than " +
                      std::to_string(kMaxState));
  layout.extra_units.resize(layout.extra.size(), "1");
  for (const OwnState& state : states) {
    layout.extra.push_back(device + '_' + state.name);
    layout.extra_units.push_back(state.unit);
    motion.own.push_back({state.time_constant, state.density});
  }
  return range;
}

/// A clock that is unknown anew at each update walks by this standard deviation between
/// two of them, 1000 km, beside which what it was before and any range are nothing. A
/// walk, so that whoever sees too few devices of it is told blind.
constexpr double kFreeClock = 1e6;

/// The state of a device's clock, which those of one clock share.
std::optional<int> clock_of(const Scene& scene, const DeviceEntry& entry,
                            MotionModel& motion) {
  const std::string state = clock_state(entry);
  if (state.empty()) return std::nullopt;
  if (const auto known = state_named(motion.layout, state)) return known;
  const ClockEntry* drift = clock_entry(scene, entry.clock);
  const GaussMarkov model =
      drift ? GaussMarkov{drift->time_constant, drift->density}
            : GaussMarkov{kInfinity, kFreeClock * kFreeClock * entry.rate};
  if (motion.layout.size() == kMaxState)
    throw Unbuildable("with the clock of " + entry.name + " the filter has more than " +
                      std::to_string(kMaxState) + " states");
  motion.layout.extra.push_back(state);
  motion.own.push_back(model);
  return motion.layout.size() - 1;
}

/// The devices beside one, of which slopes in its doubtful parameters are made.
/// @throws Unbuildable it can't be made a little off
std::vector<DoubtfulParameter> doubtful_parameters(const PluginInfo& info,
                                                   const DeviceEntry& entry) {
  constexpr double kStep = 1e-3;  // of a deviation: far above rounding, and straight
  std::vector<DoubtfulParameter> doubtful;
  for (const auto& [name, deviation] : entry.calibration.params) {
    const auto row =
        std::find_if(info.params, info.params + info.n_params,
                     [&](const ParamSpec& spec) { return name == spec.name; });
    const double value = entry.params[name];
    const double above = std::min(value + kStep * deviation, row->upper),
                 below = std::max(value - kStep * deviation, row->lower);
    const auto with = [&](double other) {
      ParamValues params = entry.params;
      params.set(name, other);
      return make_device(info, params);
    };
    doubtful.push_back({name, deviation, with(above), with(below), above - below});
  }
  return doubtful;
}

PlacedCommonError placed_error(const Scene& scene, const CommonError& common) {
  PlacedCommonError placed{common.name, {}, common.of};
  for (const Group& group : scene.groups)
    if (group.name == common.group) placed.X_WF = pose_of(group.placement);
  return placed;
}

std::vector<std::size_t> common_errors_of(const Scene& scene,
                                          const DeviceEntry& entry) {
  std::vector<std::size_t> shared;
  for (std::size_t i = 0; i < scene.common_errors.size(); ++i)
    if (shares_error(scene.common_errors[i], entry)) shared.push_back(i);
  return shared;
}

/// The scene's markers, then those of its bodies.
std::vector<PlacedMarker> placed_markers(const Scene& scene) {
  std::vector<PlacedMarker> markers(scene.markers.begin(), scene.markers.end());
  for (const MarkerBody& body : scene.bodies) {
    const Pose X_TB = pose_of(body.placement);
    for (const MarkerEntry& entry : body.markers) {
      PlacedMarker marker = X_TB * entry.at;
      if (entry.normal) {
        marker.normal = X_TB.R * entry.normal->stableNormalized();
        marker.half_angle = entry.half_angle.value_or(body.half_angle);
      }
      markers.push_back(marker);
    }
  }
  return markers;
}

}  // namespace

System::System() = default;
System::System(const System&) = default;
System::System(System&&) noexcept = default;
System& System::operator=(const System&) = default;
System& System::operator=(System&&) noexcept = default;
System::~System() = default;

Occluders placed_body(const OccluderEntry& entry) {
  return Occluders({placed_mesh(entry)}, {entry.room});
}

System build_system(const Scene& scene, PluginRegistry& plugins,
                    const System* previous) {
  System system;
  const bool single = scene.covariance == CovarianceKind::single;
  system.motion = single ? no_motion(covariance_layout(scene)) : scene.motion;
  system.fusion = definition_of(scene).fusion;
  system.covariance = scene.covariance;
  system.lag = scene.lag;
  system.error = scene.error;
  system.exposures = scene.exposures;
  system.own_metrics = known_metrics(scene).own;
  system.markers = placed_markers(scene);
  system.skin = scene.skin;
  system.occluders = all_occluders(scene);
  if (previous && previous->occluders == system.occluders) {
    system.in_world = previous->in_world;
    system.on_target = previous->on_target;
  } else {
    system.in_world = placed_occluders(system.occluders, Mount::world);
    system.on_target = placed_occluders(system.occluders, Mount::target);
  }
  system.beacon_sets = scene.beacons;
  BeaconSharing beacons(scene, previous);
  system.devices.reserve(scene.devices.size());
  for (const DeviceEntry& entry : scene.devices) {
    PlacedDevice placed;
    placed.name = entry.name;
    placed.type = entry.type;
    placed.params = entry.params;
    placed.device = reuse(previous, system.devices.size(), entry);
    placed.calibration = entry.calibration;
    placed.common_errors = common_errors_of(scene, entry);
    placed.without_sight = entry.without_sight;
    const PluginLoad& plugin = plugins.find(entry.type);
    if (!plugin.info) throw std::runtime_error(plugin.error);
    if (!placed.device) placed.device = make_device(*plugin.info, entry.params);
    placed.lenses = placed.device->lenses();
    if (placed.lenses.empty())
      throw Unbuildable(entry.name + ": its plugin " + entry.type +
                        " says of no lens where it is");
    placed.doubtful = doubtful_parameters(*plugin.info, entry);
    if (entry.mount == Mount::target) {
      placed.mount =
          TargetMount{pose_of(entry.placement),
                      placed.device->span() == Span::point
                          ? beacons(system.devices.size(), entry)
                          : std::make_shared<const BeaconIndex>(std::vector<Beacon>{}),
                      entry.beacons, entry.select, entry.count};
    } else {
      placed.mount = WorldMount{device_pose(scene, entry)};
    }
    placed.noise = noise_of(entry);
    placed.period = single ? 1 : 1 / rate_of(entry);
    placed.phase = single ? 0 : entry.phase;
    placed.exposure = exposure_of(entry);
    placed.clock = clock_of(scene, entry, system.motion);
    placed.own = add_states(placed.name, placed.device->states(), system.motion);
    system.devices.push_back(std::move(placed));
  }
  for (const CommonError& common : scene.common_errors)
    system.common_errors.push_back(placed_error(scene, common));
  system.speed = scene.speed;
  return system;
}

int information_size(const System& system) {
  const StateLayout& layout = system.motion.layout;
  const bool pose_alone = std::all_of(
      system.devices.begin(), system.devices.end(), [](const PlacedDevice& d) {
        const Span span = d.device->span();
        return !d.clock && d.own.size == 0 &&
               (span == Span::point || span == Span::pose);
      });
  return pose_alone ? layout.coordinates() : layout.size();
}

bool has_one_exposure(const System& system) {
  return std::all_of(system.devices.begin(), system.devices.end(),
                     [&](const PlacedDevice& d) {
                       return d.exposure == system.devices.front().exposure;
                     });
}

bool has_constant_errors(const System& system) {
  return !system.common_errors.empty() ||
         std::any_of(system.devices.begin(), system.devices.end(),
                     [](const PlacedDevice& d) {
                       return !d.calibration.exact() || d.without_sight.bias != 0;
                     });
}

Definition definition_of(const System& system) {
  return {system.fusion, system.covariance, system.lag,
          has_constant_errors(system) ? std::optional(system.error) : std::nullopt};
}

bool counts_bias(const System& system) {
  return definition_of(system).error.value_or(ErrorPart::scatter) != ErrorPart::scatter;
}

double information_weight(const System& system, const PlacedDevice& device) {
  return system.fusion == Fusion::continuous ? 1 / device.period : 1;
}

}  // namespace delos
