#include "delos/field/doubts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "delos/field/device_use.h"
#include "delos/observe/beacon_use.h"
#include "delos/plugin/registry.h"
#include "delos/scene/places.h"
#include "delos/text/format.h"
#include "delos/text/numbers.h"
#include "delos/text/units.h"
#include "rig/sight.h"

namespace delos {
namespace {

/// Places that are looked at, and questions to devices in all: what keeps doubts cheap.
constexpr std::size_t kMostPlaces = 1000, kMostQuestions = 300'000;
/// One place in so many: a device that sees fewer is of next to no use.
constexpr std::size_t kHardlyEver = 100;
/// Radians: narrower views are seldom meant.
constexpr double kNarrow = std::numbers::pi / 180;
constexpr double kDegree = std::numbers::pi / 180;

/// The scene and some of its places.
struct Doubted {
  const Scene& scene;
  const System& system;
  PluginRegistry& plugins;
  std::vector<TargetPose> poses;  // outside solids
  std::vector<Remark> found;

  void add(std::string path, std::string message) {
    found.push_back({std::move(path), std::move(message)});
  }
};

std::string metres(double length) { return format_quantity(length, "m"); }

std::string of_places(std::size_t count, std::size_t places) {
  return (count == 0 ? "none" : grouped(count)) + " of " + grouped(places) +
         (places == 1 ? " sample" : " samples") + " looked at";
}

/// How far points reach along the axis that they reach farthest along.
template <class Range, class Point>
double extent(const Range& range, const Point& point) {
  Eigen::AlignedBox3d box;
  for (const auto& item : range) box.extend(point(item));
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

// ---- what may be meant instead ----

/// Another way to write a value, and the device that it makes.
struct Instead {
  std::string text;  // "focal: 6 mm"
  PlacedDevice placed;
};

/// The device with angles that are in degrees where radians were read, or the other
/// way round.
void add_other_angles(const Doubted& in, std::size_t device, std::vector<Instead>& to) {
  DeviceEntry entry = in.scene.devices[device];
  auto* rpy = std::get_if<Rpy>(&entry.placement.facing);
  if (!rpy || rpy->angles.isZero(0)) return;
  const Eigen::Vector3d given = rpy->angles;
  const double largest = given.cwiseAbs().maxCoeff();
  for (const auto& [factor, unit] :
       {std::pair{kDegree, " deg"}, std::pair{1 / kDegree, " rad"}}) {
    // Radians seldom exceed half a turn, nor degrees that are radians 6.3.
    if (factor < 1 ? largest <= std::numbers::pi
                   : largest > 2 * std::numbers::pi * kDegree)
      continue;
    rpy->angles = factor * given;
    const Eigen::Vector3d shown = factor < 1 ? given : rpy->angles;
    std::string text = "rpy: [";
    for (int i = 0; i < 3; ++i)
      text += format_quantity(shown(i), "1") + unit + (i < 2 ? ", " : "]");
    PlacedDevice placed = in.system.devices[device];
    placed.X_WS() = device_pose(in.scene, entry);
    to.push_back({std::move(text), std::move(placed)});
  }
}

/// The device with a length in millimetres where metres were read, or an angle in
/// degrees where radians were.
void add_other_params(const Doubted& in, std::size_t device, std::vector<Instead>& to) {
  const PlacedDevice& placed = in.system.devices[device];
  const PluginInfo* info = in.plugins.find(placed.type).info;
  for (std::uint32_t i = 0; info && i < info->n_params; ++i) {
    const ParamSpec& spec = info->params[i];
    if (spec.kind != ParamKind::number) continue;
    const std::string unit = spec.unit;
    const bool length = unit == "m", angle = unit == "rad";
    const double value = placed.params[spec.name];
    const double meant = value * (length ? 1e-3 : kDegree);
    if ((!length && !angle) || !std::isfinite(value)) continue;
    if (meant < spec.lower || meant > spec.upper) continue;
    if (angle && value <= std::numbers::pi) continue;
    ParamValues params = placed.params;
    params.set(spec.name, meant);
    try {
      Instead instead{std::string(spec.name) + ": " + format_quantity(value, "1", 6) +
                          (length ? " mm" : " deg"),
                      placed};
      instead.placed.device = make_device(*info, params);
      to.push_back(std::move(instead));
    } catch (const std::exception&) {
      // The plugin says that it clashes with another value: it isn't meant.
    }
  }
}

/// "; do you mean 'focal: 6 mm'? Then it would see 75 of them", or nothing: only what
/// makes it see ten times as much, and a tenth of all at least.
std::string sees_instead(const Doubted& in, std::size_t device, std::size_t sees) {
  std::vector<Instead> all;
  add_other_angles(in, device, all);
  add_other_params(in, device, all);
  std::size_t most = std::max(10 * sees, in.poses.size() / 10);
  std::string text;
  for (const Instead& instead : all) {
    const std::size_t seen = in_view(in.system, instead.placed, in.poses);
    if (seen <= most) continue;
    most = seen;
    text = "; do you mean '" + instead.text + "'? Then " + grouped(seen) +
           (seen == 1 ? " is" : " are") + " in its view";
  }
  return text;
}

// ---- why a device is of no use ----

/// What a body is called in messages and paths.
std::string path_of(const Doubted& in, std::size_t occluder) {
  const std::string& name = in.scene.occluders[occluder].name;
  return "occluders." + (name.empty() ? std::to_string(occluder) : name);
}

/// Each body of the world by itself, where any is near.
std::vector<std::pair<std::size_t, Occluders>> world_bodies(const Doubted& in) {
  std::vector<std::pair<std::size_t, Occluders>> all;
  for (std::size_t i = 0; i < in.scene.occluders.size(); ++i)
    if (in.scene.occluders[i].mount == Mount::world)
      all.emplace_back(i, placed_body(in.scene.occluders[i]));
  return all;
}

/// Which body is around a device, or right before it; else empty.
std::string body_at(const Doubted& in, const PlacedDevice& placed,
                    const DeviceUse& use) {
  const Eigen::Vector3d& device = placed.X_WS().p;
  const bool inside = in.system.in_world.contains(device);
  if (!inside && 2 * use.at_once <= use.hidden) return "";
  for (const auto& [i, body] : world_bodies(in)) {
    if (body.contains(device))
      return "it stands inside of " + path_of(in, i) +
             ", which hides them; move one of the two, or give the body 'room: true' "
             "if its inside is free";
    if (inside) continue;
    for (const TargetPose& pose : in.poses)
      if (body.blocks(device,
                      device + DeviceUse::kAtOnce * (pose.p - device).normalized(),
                      in.system.skin))
        return path_of(in, i) + " is right before it and hides " + grouped(use.hidden) +
               "; move the device out of it, or raise 'skin'";
  }
  return "";
}

std::string too_far_text(const DeviceUse& use) {
  return "are too far, " + metres(use.nearest) + " away or more, and it sees up to " +
         metres(use.reach);
}

std::string too_near_text(const DeviceUse& use) {
  return "are too near, " + metres(use.farthest) + " away or less, and it sees from " +
         metres(use.least_reach) + " on";
}

/// "60 are outside of its view, 15 are hidden"
std::string reasons(const DeviceUse& use) {
  std::string text;
  const auto add = [&](std::size_t count, const std::string& why) {
    if (count == 0) return;
    text += (text.empty() ? "" : ", ") +
            (count == use.places ? "they" : grouped(count)) + ' ' + why;
  };
  add(use.aside, "are outside of its view, or behind it");
  add(use.too_far, too_far_text(use));
  add(use.too_near, too_near_text(use));
  add(use.hidden, "are hidden by what stands in between");
  return text;
}

/// What a thousandth of all distances would do.
std::string in_millimetres(const DeviceUse& use) {
  if (2 * use.sees_thousandth <= use.places || 2 * use.too_far <= use.places) return "";
  return "; do you mean millimetres? Then write '1500 mm', or 1.5";
}

void doubt_device(Doubted& in, std::size_t device) {
  const PlacedDevice& placed = in.system.devices[device];
  if (placed.carried() || placed.device->span() == Span::state) return;
  const std::string path = "devices." + placed.name;
  const std::size_t places = in.poses.size();
  const DeviceUse use = device_use(in.system, placed, in.poses);
  if (use.sees * kHardlyEver < places) {
    std::string why = body_at(in, placed, use);
    if (why.empty()) {
      why = reasons(use);
      const std::string millimetres = in_millimetres(use);
      why += millimetres.empty() ? sees_instead(in, device, use.sees) : millimetres;
    }
    in.add(path, "sees " + of_places(use.sees, places) + ": " + why);
    return;
  }
  const double view = field_of_view(in.system, placed, in.poses);
  if (!(view < kNarrow)) return;
  std::string text = "its field of view is " + format_quantity(view, "rad") + " wide";
  std::vector<Instead> all;
  add_other_params(in, device, all);
  for (const Instead& instead : all) {
    if (!(field_of_view(in.system, instead.placed, in.poses) >= kNarrow)) continue;
    text += "; do you mean '" + instead.text + "'?";
    break;
  }
  in.add(path, std::move(text));
}

/// Devices on the target that see no beacon.
void doubt_carried(Doubted& in) {
  for (const std::string& why : blind_devices(in.system, in.poses)) {
    const std::size_t blank = why.find(" sees no beacon");
    in.add("devices." + why.substr(0, blank), why.substr(blank + 1));
  }
}

// ---- lengths of the wrong size ----

void doubt_sizes(Doubted& in) {
  constexpr double kFar = 1000, kWide = 100, kOrdinary = 10;
  std::vector<Eigen::Vector3d> places;
  for (const PlacedDevice& placed : in.system.devices)
    if (!placed.carried() && placed.device->span() != Span::state)
      places.push_back(placed.X_WS().p);
  if (places.empty() || in.poses.empty()) return;
  const auto own = [](const Eigen::Vector3d& p) { return p; };
  const auto place = [](const TargetPose& pose) { return pose.p; };
  const double width = std::max(1.0, extent(in.poses, place));
  const double spread = std::max(1.0, extent(places, own));
  Eigen::AlignedBox3d box;
  for (const TargetPose& pose : in.poses) box.extend(pose.p);
  for (const PlacedDevice& placed : in.system.devices) {
    if (placed.carried() || placed.device->span() == Span::state) continue;
    const double away = box.exteriorDistance(placed.X_WS().p);
    if (away > kFar * width &&
        box.exteriorDistance(1e-3 * placed.X_WS().p) < kOrdinary * width)
      in.add("devices." + placed.name,
             "is " + metres(away) + " from the samples, which are " + metres(width) +
                 " wide; do you mean millimetres?");
  }
  if (places.size() > 1 && width > 1e3 && width > kWide * spread &&
      1e-3 * width < kOrdinary * spread)
    in.add("sample", "the samples are " + metres(width) +
                         " wide and the devices within " + metres(spread) +
                         "; do you mean millimetres?");
}

// ---- bodies that hold everything ----

void doubt_bodies(Doubted& in, const std::vector<TargetPose>& all) {
  std::vector<Eigen::Vector3d> devices;
  for (const PlacedDevice& placed : in.system.devices)
    if (!placed.carried()) devices.push_back(placed.X_WS().p);
  const bool some =
      in.poses.size() < all.size() ||
      std::any_of(devices.begin(), devices.end(), [&](const Eigen::Vector3d& p) {
        return in.system.in_world.contains(p);
      });
  if (!some) return;
  for (const auto& numbered : world_bodies(in)) {
    const auto& [i, placed] = numbered;
    const Occluders& body = placed;  // a lambda can't capture what is bound
    const bool samples = std::all_of(all.begin(), all.end(), [&](const TargetPose& at) {
      return body.contains(at.p);
    });
    const bool rig = !devices.empty() &&
                     std::all_of(devices.begin(), devices.end(),
                                 [&](const auto& p) { return body.contains(p); });
    if (!samples && !rig) continue;
    const std::string what = samples && rig ? "all samples and all devices"
                             : samples      ? "all samples"
                                            : "all devices";
    in.add(path_of(in, i), "is a solid that holds " + what +
                               "; if it is a room, give it 'room: true', so that its "
                               "inside is free; else move it");
  }
}

/// A device that candidates are copies of stands for them: its own place means nothing.
bool is_copied(const Scene& scene, const std::string& name) {
  const auto& candidates = scene.selection.candidates;
  return std::any_of(candidates.begin(), candidates.end(), [&](const auto& entry) {
    const auto* copies = std::get_if<CandidateCopies>(&entry.what);
    return copies && copies->of == name;
  });
}

}  // namespace

std::vector<Remark> doubts(const Scene& scene, const System& system,
                           PluginRegistry& plugins) {
  Doubted in{scene, system, plugins, {}, {}};
  const std::size_t most =
      std::clamp(kMostQuestions / std::max<std::size_t>(1, system.devices.size()),
                 std::size_t{100}, kMostPlaces);
  const std::vector<TargetPose> all = spread_poses(scene, most);
  for (const TargetPose& pose : all)
    if (!deep_inside_solid(system, pose.p)) in.poses.push_back(pose);
  doubt_sizes(in);
  doubt_bodies(in, all);
  if (in.poses.empty()) return std::move(in.found);
  for (std::size_t d = 0; d < system.devices.size(); ++d)
    if (!is_copied(scene, system.devices[d].name)) doubt_device(in, d);
  doubt_carried(in);
  return std::move(in.found);
}

}  // namespace delos
