#include "scene/calibration_keys.h"

#include <algorithm>
#include <span>
#include <string_view>

#include "delos/scene/definition.h"
#include "delos/text/units.h"
#include "document/node_text.h"

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

/// In whatever unit the device's readings have.
void read_offset(Reader& reader, const Place& at, Calibration& out) {
  if (!reader.expect(at, Node::Kind::scalar, "a number")) return;
  for (const char* unit : {"1", "m", "rad", "px", "s", "m/s", "rad/s", "m/s^2"}) {
    const auto parsed = parse_quantity(at.node().text, unit);
    if (const auto* offset = std::get_if<double>(&parsed)) {
      if (is_deviation(reader, at, *offset)) out.offset = *offset;
      return;
    }
  }
  reader.number(at, "1");  // which says what is wrong
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
  const PluginInfo* info = nullptr;
};

constexpr char kMetres[] = "m", kRadians[] = "rad";

template <const char* kUnit>
std::vector<Shape> deviation_forms() {
  return {number(kUnit, at_least(0)), numbers(kUnit, 3, 3, at_least(0))};
}

constexpr std::array<Key<Draft>, 4> kCalibrationKeys = {{
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
     [](Reader& r, const Place& p, Draft& d) { read_offset(r, p, d.calibration); },
     [](const Draft& d) -> Written {
       if (d.calibration.offset == 0) return std::nullopt;
       return to_node(d.calibration.offset);
     }},
    {"params", Need::optional, "of its own parameters, by their names", parameters(),
     [](Reader& r, const Place& p, Draft& d) {
       read_known_params(r, p, d.info, d.calibration);
     },
     [](const Draft& d) { return params_node(d.calibration); }},
}};

/// What a device's readings can't tell of its errors; empty: nothing.
std::string untold(const std::string& key, const DeviceEntry& entry,
                   const Device& device, const StateLayout* layout) {
  const bool carried = entry.mount == Mount::target;
  const bool turn = key == "orientation";
  if (key == "place" || turn) {
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

}  // namespace

std::vector<KeyShape> calibration_keys() { return keys_of<kCalibrationKeys>(); }

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
  if (problem.empty()) return;
  for (std::size_t i = 0; i < scene.devices.size(); ++i)
    if (!scene.devices[i].calibration.exact())
      reader.error_within(
          root, root.node().find("devices")->items[i].find("calibration")->mark,
          "devices." + scene.devices[i].name + ".calibration", problem);
}

}  // namespace delos
