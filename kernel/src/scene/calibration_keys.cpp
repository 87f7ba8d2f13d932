#include "scene/calibration_keys.h"

#include <algorithm>
#include <span>
#include <string_view>

#include "delos/device/faults.h"
#include "delos/scene/definition.h"
#include "document/node_text.h"
#include "scene/reading_unit.h"
#include "scene/search_keys.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

bool is_deviation(Reader& reader, const Place& at, double value) {
  if (value >= 0) return true;
  reader.error(at, "is a standard deviation, which must not be below 0");
  return false;
}

/// A standard deviation, the same along all axes, or three of them.
void read_deviations(Reader& reader, const Place& at, bool angles,
                     Eigen::Vector3d& out) {
  Eigen::Vector3d read;
  if (at.node().kind == Node::Kind::list) {
    const auto three = reader.vector3(at, angles ? "rad" : "m");
    if (!three) return;
    read = *three;
  } else {
    const auto one = angles ? reader.angle(at) : reader.number(at, "m");
    if (!one) return;
    read.setConstant(*one);
  }
  if (is_deviation(reader, at, read.minCoeff())) out = read;
}

Written deviations_node(const Eigen::Vector3d& deviations) {
  if (deviations.isZero(0)) return std::nullopt;
  if ((deviations.array() == deviations(0)).all()) return to_node(deviations(0));
  return vector_node(deviations);
}

void read_deviation_of(Reader& reader, const Place& at, const char* unit, double& out) {
  const auto value = reader.number(at, unit);
  if (value && is_deviation(reader, at, *value)) out = *value;
}

Written deviation_node(double deviation) {
  if (deviation == 0) return std::nullopt;
  return to_node(deviation);
}

/// The plugin's row of a name; null where it has none.
const ParamSpec* row_named(const PluginInfo& info, const std::string& name) {
  const std::span<const ParamSpec> rows(info.params, info.n_params);
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const ParamSpec& spec) {
    return name == spec.name;
  });
  return row == rows.end() ? nullptr : &*row;
}

/// @param info null where the plugin isn't known, which is another finding
void read_known_params(Reader& reader, const Place& at, const PluginInfo* info,
                       Calibration& out) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of parameters to deviations"))
    return;
  if (!info) return;
  std::vector<std::string> numbers;
  for (const ParamSpec& spec : std::span(info->params, info->n_params))
    if (spec.kind == ParamKind::number) numbers.emplace_back(spec.name);
  const Node& node = at.node();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const std::string& name = node.keys[i].text;
    const Place place(at, name, node.items[i]);
    const ParamSpec* row = row_named(*info, name);
    if (!row || row->kind != ParamKind::number) {
      reader.error_within(at, node.keys[i].mark, name,
                          row ? "isn't a number, whose deviation could be told"
                              : "is no parameter of it" + suggestion(name, numbers));
      continue;
    }
    const bool angle = std::string_view(row->unit) == "rad";
    const auto deviation =
        angle ? reader.angle(place) : reader.number(place, row->unit);
    if (deviation && is_deviation(reader, place, *deviation) && *deviation > 0)
      out.params.emplace_back(name, *deviation);
  }
}

Written params_node(const Calibration& calibration) {
  if (calibration.params.empty()) return std::nullopt;
  Node map;
  map.kind = Node::Kind::map;
  for (const auto& [name, deviation] : calibration.params) {
    map.keys.push_back({name, {}});
    map.items.push_back(to_node(deviation));
  }
  return map;
}

struct Draft {
  Calibration calibration;
  const PluginInfo* info = nullptr;  ///< of one device
  std::vector<std::string> devices;  ///< that have them in common
  std::string group;
  const Scene* scene = nullptr;  ///< of these
};

constexpr char kMetres[] = "m", kRadians[] = "rad";

template <const char* kUnit>
std::vector<Shape> deviation_forms() {
  return {number(kUnit, at_least(0)), numbers(kUnit, 3, 3, at_least(0))};
}

constexpr std::array<Key<Draft>, 5> kErrorKeys = {{
    {"place", Need::optional,
     "standard deviation of where it stands, one or along each of its axes",
     either(deviation_forms<kMetres>),
     [](Reader& r, const Place& p, Draft& d) {
       read_deviations(r, p, false, d.calibration.place);
     },
     [](const Draft& d) { return deviations_node(d.calibration.place); }},
    {"orientation", Need::optional,
     "of how it is turned, one or about each of its axes",
     either(deviation_forms<kRadians>),
     [](Reader& r, const Place& p, Draft& d) {
       read_deviations(r, p, true, d.calibration.orientation);
     },
     [](const Draft& d) { return deviations_node(d.calibration.orientation); }},
    {"offset", Need::optional, "of what each of its readings is off by, all the time",
     number(nullptr, at_least(0)),
     [](Reader& r, const Place& p, Draft& d) {
       const auto value = read_in_any_unit(r, p);
       if (value && is_deviation(r, p, *value)) d.calibration.offset = *value;
     },
     [](const Draft& d) { return deviation_node(d.calibration.offset); }},
    {"scale", Need::optional, "of its readings, as a part of each, such as 0.2 %",
     number("1", at_least(0)),
     [](Reader& r, const Place& p, Draft& d) {
       read_deviation_of(r, p, "1", d.calibration.scale);
     },
     [](const Draft& d) { return deviation_node(d.calibration.scale); }},
    {"delay", Need::optional,
     "of how much older its readings are than taken for; counts with target.speed",
     number("s", at_least(0)),
     [](Reader& r, const Place& p, Draft& d) {
       read_deviation_of(r, p, "s", d.calibration.delay);
     },
     [](const Draft& d) { return deviation_node(d.calibration.delay); }},
}};

constexpr std::array<Key<Draft>, 1> kOneDeviceKeys = {{
    {"params", Need::optional, "of its own parameters, by their names", parameters(),
     [](Reader& r, const Place& p, Draft& d) {
       read_known_params(r, p, d.info, d.calibration);
     },
     [](const Draft& d) { return params_node(d.calibration); }},
}};
constexpr auto kCalibrationKeys = concat(kErrorKeys, kOneDeviceKeys);

constexpr std::array<Key<Draft>, 2> kMemberKeys = {{
    {"devices", Need::optional,
     "which devices have them in common; default: those of the group, or all in the "
     "world",
     names(),
     [](Reader& r, const Place& p, Draft& d) {
       d.devices = read_device_names(r, p, *d.scene);
     },
     [](const Draft& d) -> Written {
       if (d.devices.empty()) return std::nullopt;
       std::vector<Node> names;
       for (const std::string& name : d.devices) names.push_back(to_node(name));
       return to_node(std::move(names));
     }},
    {"group", Need::optional,
     "about whose origin and axes place and orientation are; default: the world's",
     text(),
     [](Reader& r, const Place& p, Draft& d) {
       auto group = r.word(p);
       if (!group) return;
       std::vector<std::string> known;
       for (const Group& one : d.scene->groups) known.push_back(one.name);
       if (std::find(known.begin(), known.end(), *group) == known.end())
         r.error(p, "there is no group '" + *group + '\'' + suggestion(*group, known));
       d.group = std::move(*group);
     },
     [](const Draft& d) -> Written {
       if (d.group.empty()) return std::nullopt;
       return to_node(d.group);
     }},
}};
constexpr auto kCommonErrorKeys = concat(kMemberKeys, kErrorKeys);

/// What a device's readings can't tell of its errors; empty: nothing.
std::string untold(const std::string& key, const DeviceEntry& entry,
                   const Device& device, const StateLayout* layout) {
  const bool carried = entry.mount == Mount::target;
  const bool turn = key == "orientation";
  if (key == "place" || key == "delay" || turn) {
    if (device.span() == Span::state)
      return "says nothing to a device that measures the state, wherever it is";
    if (carried && device.span() != Span::point)
      return "isn't known for a device that measures the target's motion; give an "
             "offset";
    if (carried && layout && (turn ? layout->turns() < 3 : layout->positions() < 3))
      return "of a carried device needs a motion whose state has the whole " +
             std::string(turn ? "orientation" : "position");
    return "";
  }
  return carried && device.span() == Span::point
             ? "isn't known for a device that looks at beacons; give its place and "
               "orientation"
             : "";
}

/// A problem of errors, at the key that they are written under.
void refuse_errors(Reader& reader, const Place& root, const Scene& scene,
                   const std::string& problem) {
  for (std::size_t i = 0; i < scene.devices.size(); ++i) {
    const DeviceEntry& device = scene.devices[i];
    const Node& node = root.node().find("devices")->items[i];
    const auto say = [&](const char* key) {
      reader.error_within(root, node.find(key)->mark,
                          "devices." + device.name + '.' + key, problem);
    };
    if (!device.calibration.exact()) say("calibration");
    if (device.without_sight.bias != 0) say("without_sight");
  }
  if (!scene.common_errors.empty())
    reader.error_within(root, root.node().find("common_errors")->mark, "common_errors",
                        problem);
}

/// What readings are late by is told by how fast the target is.
void check_delays(Reader& reader, const Place& root, const Scene& scene) {
  if (scene.speed > 0) return;
  const auto refuse_at = [&](const Place& at) {
    if (const Node* delay = at.node().find("delay"))
      reader.error_within(at, delay->mark, "delay",
                          "does nothing to a target at rest; say how fast it is, such "
                          "as target: {speed: 1.5 m/s}");
  };
  for (std::size_t i = 0; i < scene.devices.size(); ++i) {
    if (scene.devices[i].calibration.delay == 0) continue;
    const Node& device = root.node().find("devices")->items[i];
    refuse_at(Place(root, "devices." + scene.devices[i].name + ".calibration",
                    *device.find("calibration")));
  }
  for (std::size_t i = 0; i < scene.common_errors.size(); ++i)
    if (scene.common_errors[i].of.delay > 0)
      refuse_at(Place(root, "common_errors." + scene.common_errors[i].name,
                      root.node().find("common_errors")->items[i]));
}

/// Its devices must be there, stand in the world, and tell what these errors do.
void check_common_error(Reader& reader, const Place& at, const CommonError& common,
                        const Scene& scene) {
  bool any = false;
  for (const DeviceEntry& entry : scene.devices) {
    const bool named = std::find(common.devices.begin(), common.devices.end(),
                                 entry.name) != common.devices.end();
    if (named && entry.mount == Mount::target)
      reader.error(at, "is of devices in the world, but the target carries " +
                           entry.name + "; give it a calibration of its own");
    if (!shares_error(common, entry)) continue;
    any = true;
    const PluginInfo* info = reader.plugins.find(entry.type).info;
    if (!info) continue;
    try {
      const auto device = make_device(*info, entry.params);
      for (const Node::Key& key : at.node().keys)
        if (const std::string problem = untold(key.text, entry, *device, nullptr);
            !problem.empty())
          reader.error_within(at, key.mark, key.text,
                              "of " + entry.name + ' ' + problem);
    } catch (const Unbuildable&) {
      continue;  // which is another finding
    }
  }
  if (!any) reader.error(at, "is of no device");
  if (common.of.exact())
    reader.error(at, "says of no error; give one, or leave it out");
}

}  // namespace

std::vector<KeyShape> calibration_keys() { return keys_of<kCalibrationKeys>(); }
Shape common_error_shape() { return map<kCommonErrorKeys>(); }

void read_calibration(Reader& reader, const Place& at, DeviceEntry& out) {
  Draft draft;
  if (!out.type.empty()) draft.info = reader.plugins.find(out.type).info;
  if (read_map(reader, at, kCalibrationKeys, draft))
    out.calibration = std::move(draft.calibration);
}

Written write_calibration(const DeviceEntry& device) {
  if (device.calibration.exact()) return std::nullopt;
  return write_map(kCalibrationKeys, Draft{device.calibration});
}

void read_common_errors(Reader& reader, const Place& at, Scene& scene) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of names to common errors"))
    return;
  const Node& node = at.node();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Place place(at, node.keys[i].text, node.items[i]);
    const std::size_t before = reader.findings.errors();
    const std::string name = reader.key_name(at, i);
    Draft draft;
    draft.scene = &scene;
    if (!read_map(reader, place, kCommonErrorKeys, draft)) continue;
    CommonError common{name, std::move(draft.devices), std::move(draft.group),
                       std::move(draft.calibration)};
    if (reader.findings.errors() == before)
      check_common_error(reader, place, common, scene);
    scene.common_errors.push_back(std::move(common));
  }
}

Written write_common_errors(const Scene& scene) {
  if (scene.common_errors.empty()) return std::nullopt;
  Node map;
  map.kind = Node::Kind::map;
  for (const CommonError& common : scene.common_errors) {
    map.keys.push_back({common.name, {}});
    map.items.push_back(write_map(
        kCommonErrorKeys, Draft{common.of, nullptr, common.devices, common.group}));
  }
  return map;
}

void check_calibration(Reader& reader, const Place& at, const DeviceEntry& entry,
                       const Device& device, const StateLayout* layout) {
  const Node* calibration = at.node().find("calibration");
  if (!calibration || calibration->kind != Node::Kind::map) return;
  const Place place(at, "calibration", *calibration);
  for (const Node::Key& key : calibration->keys)
    if (const std::string problem = untold(key.text, entry, device, layout);
        !problem.empty())
      reader.error_within(place, key.mark, key.text, problem);
}

void check_calibrations(Reader& reader, const Place& root, const Scene& scene) {
  const Definition definition = definition_of(scene);
  std::string problem = calibration_problem(scene.motion, definition);
  const bool combined = scene.orientations.combine == OrientationRule::information &&
                        scene.orientations.rpy.size() > 1;
  if (problem.empty() && combined && definition.error &&
      *definition.error != ErrorPart::scatter)
    problem =
        "isn't known where the information of several orientations is combined; "
        "use combine: worst or mean, or error: scatter";
  if (!problem.empty()) refuse_errors(reader, root, scene, problem);
  check_delays(reader, root, scene);
}

}  // namespace delos
