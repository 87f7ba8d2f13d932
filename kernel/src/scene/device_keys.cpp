#include "scene/device_keys.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "delos/device/faults.h"
#include "delos/scene/definition.h"
#include "document/node_text.h"
#include "scene/calibration_keys.h"
#include "scene/params.h"
#include "scene/placement_keys.h"
#include "scene/sample_time_keys.h"
#include "scene/surface_keys.h"
#include "scene/without_sight_keys.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

constexpr auto kGroupKeys = kPlacementKeys<Group>;

/// One name, or a list of them.
void read_seen_beacons(Reader& reader, const Place& at, DeviceEntry& out) {
  if (at.node().kind == Node::Kind::scalar) {
    if (auto name = reader.word(at)) out.beacons = {std::move(*name)};
    return;
  }
  if (!reader.expect(at, Node::Kind::list, "the name of a set, or a list of names"))
    return;
  const auto& items = at.node().items;
  if (items.empty())
    reader.error(at, "the list is empty; leave it out to see all sets");
  for (std::size_t i = 0; i < items.size(); ++i)
    if (auto name = reader.word(Place(at, std::to_string(i), items[i])))
      out.beacons.push_back(std::move(*name));
}

Written write_seen_beacons(const DeviceEntry& d) {
  if (d.beacons.empty()) return std::nullopt;
  std::vector<Node> names;
  for (const std::string& name : d.beacons) names.push_back(to_node(name));
  return to_node(std::move(names));
}

/// One number on a rail, else a list.
std::vector<Shape> coordinate_forms() {
  return {number("1", between(0, 1)), numbers("1", 1, 2, between(0, 1))};
}

std::vector<const char*> preset_names() {
  std::vector<const char*> names;
  for (const DevicePreset& preset : device_presets()) names.push_back(preset.name);
  return names;
}

/// After the type, which it may say.
void read_preset(Reader& reader, const Place& at, DeviceEntry& out) {
  auto name = reader.word(at);
  if (!name) return;
  const DevicePreset* preset = device_preset(*name);
  if (!preset) {
    std::vector<std::string> known;
    for (const DevicePreset& one : device_presets()) known.emplace_back(one.name);
    return reader.error(
        at, "there is no preset '" + *name + '\'' + suggestion(*name, known));
  }
  if (out.type.empty()) out.type = preset->type;
  if (out.type != preset->type)
    return reader.error(at, "is of a " + std::string(preset->type) + ", not of a " +
                                out.type + "; leave 'type' out");
  out.preset = std::move(*name);
}

constexpr std::array<Key<DeviceEntry>, 24> kDeviceKeys = {{
    member_key<&DeviceEntry::name>("name", Need::required,
                                   "a word of your own that messages and paths use",
                                   name()),
    {"type", Need::optional,
     "id of the plugin that models it; required where no preset says it", text(),
     [](Reader& r, const Place& p, DeviceEntry& d) {
       if (auto type = r.word(p)) d.type = std::move(*type);
       if (p.node().kind == Node::Kind::scalar && d.type.empty())
         r.error(p, "is empty; 'delos devices' lists the plugins");
     },
     [](const DeviceEntry& d) -> Written { return to_node(d.type); }},
    {"preset", Need::optional,
     "published figures of a device that one can buy; 'delos devices --presets' lists "
     "them",
     choice_of(preset_names), read_preset,
     [](const DeviceEntry& d) -> Written {
       if (d.preset.empty()) return std::nullopt;
       return to_node(d.preset);
     }},
    {"rate", Need::optional, "updates a second, such as 50 Hz",
     number("1/s", above(0, "; a device that is off is left out")),
     MemberRow<&DeviceEntry::rate>::read,
     [](const DeviceEntry& d) -> Written {
       if (d.timing) return std::nullopt;
       return to_node(d.rate);
     }},
    other_key<&DeviceEntry::phase>(
        "phase", Need::optional, "delay of the first update; periodic fusion reads it",
        number("s", at_least(0))),
    other_key<&DeviceEntry::exposure>(
        "exposure", Need::optional,
        "how long a reading takes, up to its update: it's the mean over that time",
        number("s", at_least(0))),
    {"timing", Need::optional,
     "instead of a rate: what an update takes beside its exposure", map(timing_keys),
     read_timing, write_timing},
    {"noise_over_time", Need::optional,
     "how the noise falls with the exposure; default: constant",
     map(noise_over_time_keys), read_noise_over_time, write_noise_over_time},
    {"mount", Need::optional,
     "world: it stands in the room and sees the target; target: it is carried and sees "
     "beacons",
     choice<kMountWords>(),
     [](Reader& r, const Place& p, DeviceEntry& d) {
       if (const auto mount = r.choice(p, kMountWords)) d.mount = *mount;
     },
     [](const DeviceEntry& d) -> Written {
       if (d.mount == Mount::world) return std::nullopt;
       return to_node(word_of(kMountWords, d.mount));
     }},
    {"beacons", Need::optional, "the sets that a carried device sees; default: all",
     names(), read_seen_beacons, write_seen_beacons},
    {"select", Need::optional,
     "which sightings an update uses: all, mean, random, nearest or best",
     choice<kSightingRuleWords>(),
     [](Reader& r, const Place& p, DeviceEntry& d) {
       if (const auto rule = r.choice(p, kSightingRuleWords)) d.select = *rule;
     },
     [](const DeviceEntry& d) -> Written {
       if (d.mount == Mount::world) return std::nullopt;
       return to_node(word_of(kSightingRuleWords, d.select));
     }},
    {"count", Need::optional, "how many sightings an update uses", integer(1),
     [](Reader& r, const Place& p, DeviceEntry& d) {
       if (const auto n = r.integer(p)) d.count = *n;
     },
     [](const DeviceEntry& d) -> Written {
       if (d.mount == Mount::world || d.select == SightingRule::all)
         return std::nullopt;
       return to_node(d.count);
     }},
    other_key<&DeviceEntry::clock>(
        "clock", Need::optional,
        "its readings and those of all devices of this clock are off by one unknown "
        "number",
        name()),
    other_key<&DeviceEntry::group>("group", Need::optional,
                                   "the group that it is placed in; default: the world",
                                   text()),
    {"at", Need::optional, kAtKey<DeviceEntry>.help, kAtKey<DeviceEntry>.shape,
     kAtKey<DeviceEntry>.read,
     [](const DeviceEntry& d) -> Written {
       if (d.mounting) return std::nullopt;
       return write_at(d.placement);
     }},
    {"on", Need::optional, "the surface that it is mounted on, instead of `at`", text(),
     read_on, write_on},
    {"coordinates", Need::optional, "where on the surface, numbers from 0 to 1",
     either(coordinate_forms), read_coordinates, write_coordinates},
    kAimKey<DeviceEntry>,
    kRollKey<DeviceEntry>,
    kRpyKey<DeviceEntry>,
    kQuaternionKey<DeviceEntry>,
    {"params", Need::optional, "the plugin's own parameters", parameters(), nullptr,
     [](const DeviceEntry& d) -> Written {
       if (d.params.all().empty()) return std::nullopt;
       return write_params(d.params);
     }},
    {"calibration", Need::optional,
     "how well it is known: standard deviations of constant errors",
     map(calibration_keys), read_calibration, write_calibration},
    {"without_sight", Need::optional,
     "what becomes of readings where something stands in the way; default: none are",
     map(without_sight_keys), read_without_sight, write_without_sight},
}};

void check_group(Reader& reader, const Place& at, const DeviceEntry& device,
                 const std::vector<std::string>& groups) {
  const Node* node = at.node().find("group");
  if (!node || node->kind != Node::Kind::scalar ||
      std::find(groups.begin(), groups.end(), device.group) != groups.end())
    return;
  reader.error_within(at, node->mark, "group",
                      "there is no group '" + device.group + '\'' +
                          (groups.empty() ? "; the scene declares none"
                                          : suggestion(device.group, groups)));
}

/// Keys that only make sense on one of the mounts.
void check_mount(Reader& reader, const Place& at, const DeviceEntry& device) {
  const bool carried = device.mount == Mount::target;
  const auto refuse = [&](const char* key, const char* problem) {
    if (const Node* node = at.node().find(key))
      reader.error_within(at, node->mark, key, problem);
  };
  for (const char* key : {"group", "on"})
    if (carried)
      refuse(key, "is in the world, but mount: target moves with the target");
  if (carried) refuse("clock", "is for a device in the world; this one sees beacons");
  for (const char* key : {"beacons", "select"})
    if (!carried)
      refuse(key, "is for a device that the target carries; give 'mount: target'");
  if (!carried || device.select == SightingRule::all)
    refuse("count", "goes with 'select: mean', 'random', 'nearest' or 'best'");
}

/// A carried device that sees points needs something to look at.
void check_seen_beacons(Reader& reader, const Place& at, const DeviceEntry& device,
                        const std::vector<BeaconSet>& sets) {
  if (sets.empty())
    return reader.error_within(
        at, at.node().find("mount")->mark, "mount",
        "the scene declares no beacons for it to see; add 'beacons'");
  std::vector<std::string> known;
  for (const BeaconSet& set : sets) known.push_back(set.name);
  for (const std::string& name : device.beacons)
    if (std::find(known.begin(), known.end(), name) == known.end())
      reader.error_within(at, at.node().find("beacons")->mark, "beacons",
                          "there is no set '" + name + '\'' + suggestion(name, known));
}

/// What a device may refer to; null where it isn't known.
struct Around {
  const StateLayout* layout;
  std::vector<std::string> groups;
  const std::vector<SurfaceEntry>* surfaces;
  const std::vector<BeaconSet>* beacons;
  bool single;                           ///< a single reading is asked for
  std::vector<std::string> clocks = {};  ///< of the devices so far
  int own_states = 0;                    ///< of the devices so far
};

/// A carried device looks at beacons, or measures how it moves itself.
void check_carried(Reader& reader, const Place& at, const DeviceEntry& entry, Span span,
                   const std::vector<BeaconSet>* sets) {
  if (span == Span::point) {
    if (sets) check_seen_beacons(reader, at, entry, *sets);
    return;
  }
  if (span == Span::state)
    reader.error_within(at, at.node().find("mount")->mark, "mount",
                        entry.type +
                            " measures the state, wherever it is mounted; "
                            "leave 'mount' out");
  for (const char* key : {"beacons", "select", "count"})
    if (const Node* node = at.node().find(key);
        node &&
        !(std::string_view(key) == "select" && entry.select == SightingRule::all))
      reader.error_within(at, node->mark, key,
                          "is for a device that looks at beacons; " + entry.type +
                              " measures how the target moves");
}

/// Whether a sensor of motion measures anything that a state has, in its own frame.
bool measures(const Device& device, const StateLayout& layout) {
  Target at_rest;
  at_rest.own.setZero(static_cast<Eigen::Index>(device.states().size()));
  Observation out;
  if (!device.observe(at_rest, out) || out.H.cols() < 18) return true;  // asked later
  for (int k = 0; k < layout.order; ++k) {
    const bool moves = !out.H.middleCols(6 * k, 3).isZero(0),
               turns = !out.H.middleCols(6 * k + 3, 3).isZero(0);
    if ((moves && layout.positions() > 0) || (turns && layout.turns() > 0)) return true;
  }
  return false;
}

/// Why a device can't measure a state of these coordinates; empty where it can.
std::string pose_problem(const StateLayout& layout, Span span) {
  if (span == Span::state) return "";
  if (layout.pose == PoseState::none)
    return "measures where the target is, but this state has no pose";
  if (layout.pose == PoseState::planar && span != Span::point)
    return "measures the target's whole pose, of which the state 'planar' leaves the "
           "heading out; use planar_pose";
  return "";
}

/// Make the device, whose plugin knows which values clash.
void check_device(Reader& reader, const Place& at, const PluginInfo& info,
                  Around& around, const DeviceEntry& entry) {
  try {
    const auto device = make_device(info, entry.params);
    around.own_states += static_cast<int>(device->states().size());
    // A clock is one, too, but that single readings count it with the pose.
    const bool is_new = !entry.clock.empty() && !around.single &&
                        std::find(around.clocks.begin(), around.clocks.end(),
                                  entry.clock) == around.clocks.end();
    if (is_new) around.clocks.push_back(entry.clock);
    const StateLayout* layout = around.layout;
    if (entry.mount == Mount::target)
      check_carried(reader, at, entry, device->span(), around.beacons);
    if (entry.mount == Mount::target && device->span() == Span::point &&
        !device->states().empty())
      return reader.error_within(at, at.node().find("mount")->mark, "mount",
                                 entry.type +
                                     " has states of its own, such as a bias, "
                                     "with which it can't look at beacons");
    const bool of_pose = device->span() == Span::point || device->span() == Span::pose;
    if (entry.exposure > 0 && !of_pose)
      return reader.error_within(
          at, at.node().find("exposure")->mark, "exposure",
          "is of the pose's mean, but " + entry.type + " measures more than the pose");
    if (entry.mount == Mount::world && device->span() == Span::motion)
      reader.warning(at,
                     "stands in the room and measures the target's motion along "
                     "its own axes there; if the target carries " +
                         entry.type + ", give 'mount: target'");
    if (around.single && !of_pose)
      return reader.error(at,
                          "measures more than the pose, of which a single reading is; "
                          "use covariance: prior or posterior");
    check_calibration(reader, at, entry, *device, layout);
    check_without_sight(reader, at, entry, *device);
    if (!layout) return;
    const std::string problem = pose_problem(*layout, device->span());
    if (!problem.empty()) return reader.error(at, problem);
    if (device->span() == Span::motion && !measures(*device, *layout))
      return reader.error(at, entry.type + " measures none of this motion's states: " +
                                  joined(layout->names()));
    if (device->span() != Span::state || device->state_size() == layout->size()) return;
    std::vector<std::string> names = layout->names();
    reader.error(at, "measures a state of " + std::to_string(device->state_size()) +
                         " entries, but this motion's has " +
                         std::to_string(layout->size()) + ": " + joined(names));
  } catch (const Unbuildable& refusal) {
    const Node* params = at.node().find("params");
    const Node* value = params ? params->find(refusal.parameter()) : nullptr;
    if (value)
      reader.error_within(Place(at, "params", *params),
                          mark_of(*value, refusal.character()), refusal.parameter(),
                          refusal.what());
    else
      reader.error(at, refusal.what());
  }
}

void read_device(Reader& reader, const Place& at, Around& around, DeviceEntry& out) {
  const std::size_t before = reader.findings.errors();
  if (!read_map(reader, at, kDeviceKeys, out)) return;
  if (out.mounting) {
    const auto point = check_mounting(reader, at, out, around.surfaces);
    check_facing(reader, at, out.placement, point ? &point->p : nullptr);
  } else {
    check_placement(reader, at, out.placement);
  }
  check_mount(reader, at, out);
  check_group(reader, at, out, around.groups);
  check_sample_time(reader, at, out);
  if (out.type.empty()) {
    if (!at.node().find("type") && !at.node().find("preset"))
      reader.error_within(at, at.node().mark, "type",
                          "missing: id of the plugin that models it");
    return;
  }
  const PluginLoad& plugin = reader.plugins.find(out.type);
  if (!plugin.info) {
    const char* key = at.node().find("type") ? "type" : "preset";
    reader.error_within(at, at.node().find(key)->mark, key, plugin.error);
    return;
  }
  read_params(reader, at, *plugin.info, device_preset(out.preset), out.params);
  if (reader.findings.errors() == before)
    check_device(reader, at, *plugin.info, around, out);
}

}  // namespace

Shape group_shape() {
  return either([] { return std::vector{map<kGroupKeys>(), nothing()}; });
}
Shape device_shape() { return map<kDeviceKeys>(); }

void read_groups(Reader& reader, const Place& at, std::vector<Group>& out) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of names to poses")) return;
  const Node& node = at.node();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Place place(at, node.keys[i].text, node.items[i]);
    Group group;
    group.name = reader.key_name(at, i);
    // "rig1:" alone is a group at the origin.
    if (node.items[i].kind != Node::Kind::null &&
        read_map(reader, place, kGroupKeys, group))
      check_placement(reader, place, group.placement);
    out.push_back(std::move(group));
  }
}

void read_devices(Reader& reader, const Place& at, const Known& known, Scene& scene) {
  if (!reader.expect(at, Node::Kind::list, "a list of devices")) return;
  const Node& node = at.node();
  if (node.items.empty())
    reader.error(at, "the list is empty; a system needs a device");
  Around around{known.motion ? &scene.motion.layout : nullptr,
                {},
                known.surfaces ? &scene.surfaces : nullptr,
                known.beacons ? &scene.beacons : nullptr,
                scene.covariance == CovarianceKind::single};
  for (const Group& group : scene.groups) around.groups.push_back(group.name);
  std::map<std::string, int> line_of;
  scene.devices.reserve(node.items.size());
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Place place(at, member_name(node.items[i], i), node.items[i]);
    DeviceEntry entry;
    read_device(reader, place, around, entry);
    if (!entry.name.empty()) {
      const Mark mark = node.items[i].find("name")->mark;
      const auto [first, is_new] = line_of.emplace(entry.name, mark.line);
      if (!is_new)
        reader.error_within(place, mark, "name",
                            '\'' + entry.name + "' names the device on line " +
                                std::to_string(first->second) + " already");
    }
    scene.devices.push_back(std::move(entry));
  }
  around.own_states += static_cast<int>(around.clocks.size());
  const int states = covariance_layout(scene).size();
  if (around.single && states > kMaxState)
    reader.error(at, "have so many clocks that " + std::to_string(states) +
                         " numbers are unknown; at most " + std::to_string(kMaxState) +
                         " can be solved for");
  else if (states + around.own_states > kMaxState)
    reader.error(at, "have " + std::to_string(around.own_states) +
                         " states of their own, which make " +
                         std::to_string(states + around.own_states) +
                         " with those of the motion; at most " +
                         std::to_string(kMaxState) + " can be estimated");
  const bool exposes =
      std::any_of(scene.devices.begin(), scene.devices.end(),
                  [](const DeviceEntry& device) { return device.exposure > 0; });
  if (exposes && around.own_states > 0)
    reader.error(
        at,
        "have states of their own, such as biases and clocks, and an exposure, which "
        "aren't solved for together; leave one of them out");
}

Node write_groups(const std::vector<Group>& groups) {
  Node map;
  map.kind = Node::Kind::map;
  for (const Group& group : groups) {
    map.keys.push_back({group.name, {}});
    map.items.push_back(write_map(kGroupKeys, group));
  }
  return map;
}

Node write_devices(const std::vector<DeviceEntry>& devices) {
  std::vector<Node> list;
  for (const DeviceEntry& device : devices)
    list.push_back(write_map(kDeviceKeys, device));
  return to_node(std::move(list));
}

}  // namespace delos
