#include "scene/scene_keys.h"

#include <algorithm>

#include "delos/model/metric.h"
#include "delos/scene/definition.h"
#include "delos/text/number_text.h"
#include "delos/text/units.h"
#include "document/node_text.h"
#include "scene/beacon_keys.h"
#include "scene/calibration_keys.h"
#include "scene/clock_keys.h"
#include "scene/clutter_keys.h"
#include "scene/device_keys.h"
#include "scene/metric_keys.h"
#include "scene/motion_keys.h"
#include "scene/occluder_keys.h"
#include "scene/rooms.h"
#include "scene/sample_keys.h"
#include "scene/search_keys.h"
#include "scene/surface_keys.h"
#include "scene/target_keys.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

/// The version of the scene format that this program reads and writes.
constexpr int kFormat = 1;

/// A scene while it is read.
struct SceneDraft {
  Scene scene;
  Known known;
  bool metrics_known = true;  ///< its own ones have no findings
};

void read_format(Reader& reader, const Place& at, SceneDraft&) {
  const auto text = reader.word(at);
  if (text && *text != std::to_string(kFormat))
    reader.error(at, "'" + *text +
                         "' isn't a format version that this program reads; "
                         "it reads " +
                         std::to_string(kFormat));
}

// Read in this order: devices need the groups, the surfaces, the beacons and the
// motion's state.
constexpr std::array<Key<SceneDraft>, 28> kSceneKeys = {{
    {"delos", Need::required, "the format's version; begin the file with 'delos: 1'",
     integer(kFormat, kFormat), read_format,
     [](const SceneDraft&) -> Written { return to_node(kFormat); }},
    {"name", Need::optional, "a title", text(),
     [](Reader& r, const Place& p, SceneDraft& d) {
       if (auto name = r.word(p)) d.scene.name = std::move(*name);
       if (has_control(d.scene.name)) r.error(p, "holds a control character");
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.name.empty()) return std::nullopt;
       return to_node(d.scene.name);
     }},
    {"motion", Need::required, "how the target is expected to move", map(motion_keys),
     [](Reader& r, const Place& p, SceneDraft& d) {
       const std::size_t before = r.findings.errors();
       read_motion(r, p, d.scene.motion);
       d.known.motion = r.findings.errors() == before;
     },
     [](const SceneDraft& d) -> Written { return write_motion(d.scene.motion); }},
    {"motions", Need::optional, "other motions, by name, that it may have instead",
     table(motion_shape),
     [](Reader& r, const Place& p, SceneDraft& d) {
       read_motions(r, p, d.scene.motions);
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.motions.empty()) return std::nullopt;
       return write_motions(d.scene.motions);
     }},
    {"fusion", Need::optional, "how the measurements of several devices come together",
     choice<kFusionWords>(),
     [](Reader& r, const Place& p, SceneDraft& d) {
       d.scene.fusion = r.choice(p, kFusionWords);
     },
     [](const SceneDraft& d) -> Written {
       if (!d.scene.fusion) return std::nullopt;
       return to_node(to_string(*d.scene.fusion));
     }},
    {"sample", Need::required, "where the system is evaluated", either(sample_forms),
     [](Reader& r, const Place& p, SceneDraft& d) { read_samples(r, p, d.scene); },
     [](const SceneDraft& d) -> Written { return write_samples(d.scene); }},
    {"orientations", Need::optional, "target orientations tried at each point",
     map(orientation_keys),
     [](Reader& r, const Place& p, SceneDraft& d) {
       read_orientations(r, p, d.scene.orientations);
     },
     [](const SceneDraft& d) -> Written { return write_orientations(d.scene); }},
    {"covariance", Need::optional,
     "the one that the metric reads: prior, posterior or single",
     choice<kCovarianceWords>(),
     [](Reader& r, const Place& p, SceneDraft& d) {
       const auto kind = r.choice(p, kCovarianceWords);
       const bool no_pose = d.known.motion && d.scene.motion.layout.coordinates() == 0;
       if (kind == CovarianceKind::single && no_pose)
         r.error(p, "single is of the target's pose, which this state doesn't have");
       else if (kind)
         d.scene.covariance = *kind;
     },
     [](const SceneDraft& d) -> Written {
       return to_node(to_string(d.scene.covariance));
     }},
    {"lag", Need::optional,
     "how long after the covariance's instant it is used: processing, display",
     number("s", at_least(0, ": nothing is used before it is known")),
     [](Reader& r, const Place& p, SceneDraft& d) {
       if (const auto lag = r.number(p)) d.scene.lag = *lag;
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.lag == 0) return std::nullopt;
       return to_node(d.scene.lag);
     }},
    {"error", Need::optional,
     "which part of the error is shown: scatter, the bias of calibrations, or their "
     "total",
     choice<kErrorPartWords>(),
     [](Reader& r, const Place& p, SceneDraft& d) {
       if (const auto part = r.choice(p, kErrorPartWords)) d.scene.error = *part;
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.error == ErrorPart::total) return std::nullopt;
       return to_node(to_string(d.scene.error));
     }},
    {"exposures", Need::optional,
     "the motion in readings that take time: exact, instantaneous, averaged or "
     "integrated",
     choice<kExposureModelWords>(),
     [](Reader& r, const Place& p, SceneDraft& d) {
       if (const auto model = r.choice(p, kExposureModelWords))
         d.scene.exposures = *model;
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.exposures == ExposureModel::exact) return std::nullopt;
       return to_node(word_of(kExposureModelWords, d.scene.exposures));
     }},
    {"metrics", Need::optional, "metrics by formulas", table(metric_shape),
     [](Reader& r, const Place& p, SceneDraft& d) {
       d.metrics_known = read_metrics(r, p, d.known.motion, d.scene);
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.metrics.empty()) return std::nullopt;
       return write_metrics(d.scene.metrics);
     }},
    {"metric", Need::optional, "the number that is shown", text(),
     [](Reader& r, const Place& p, SceneDraft& d) {
       auto metric = r.word(p);
       if (!metric) return;
       const auto known = parse_metric(*metric, known_metrics(d.scene));
       const auto* problem = std::get_if<std::string>(&known);
       if (problem && d.known.motion && d.metrics_known) r.error(p, *problem);
       d.scene.metric = std::move(*metric);
     },
     [](const SceneDraft& d) -> Written { return to_node(d.scene.metric); }},
    {"target", Need::optional, "the thing that is tracked", map(target_keys),
     [](Reader& r, const Place& p, SceneDraft& d) { read_target(r, p, d.scene); },
     [](const SceneDraft& d) { return write_target(d.scene); }},
    {"groups", Need::optional, "poses that their members are relative to",
     table(group_shape),
     [](Reader& r, const Place& p, SceneDraft& d) {
       read_groups(r, p, d.scene.groups);
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.groups.empty()) return std::nullopt;
       return write_groups(d.scene.groups);
     }},
    {"surfaces", Need::optional, "what devices are mounted on", table(surface_shape),
     [](Reader& r, const Place& p, SceneDraft& d) {
       const std::size_t before = r.findings.errors();
       read_surfaces(r, p, d.scene.surfaces);
       d.known.surfaces = r.findings.errors() == before;
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.surfaces.empty()) return std::nullopt;
       return write_surfaces(d.scene.surfaces);
     }},
    {"regions", Need::optional, "named bodies", table(region_shape),
     [](Reader& r, const Place& p, SceneDraft& d) {
       read_regions(r, p, d.scene.regions);
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.regions.empty()) return std::nullopt;
       return write_regions(d.scene.regions);
     }},
    {"beacons", Need::optional, "what devices on the target look at",
     table(beacon_set_shape),
     [](Reader& r, const Place& p, SceneDraft& d) {
       const std::size_t before = r.findings.errors();
       read_beacons(r, p, d.scene.beacons);
       d.known.beacons = r.findings.errors() == before;
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.beacons.empty()) return std::nullopt;
       return write_beacons(d.scene.beacons);
     }},
    {"clocks", Need::optional, "how the clocks of devices drift", table(clock_shape),
     [](Reader& r, const Place& p, SceneDraft& d) {
       read_clocks(r, p, d.scene.clocks);
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.clocks.empty()) return std::nullopt;
       return write_clocks(d.scene.clocks);
     }},
    {"devices", Need::required, "what measures", list(device_shape, 1),
     [](Reader& r, const Place& p, SceneDraft& d) {
       read_devices(r, p, d.known, d.scene);
     },
     [](const SceneDraft& d) -> Written { return write_devices(d.scene.devices); }},
    {"common_errors", Need::optional, "constant errors that devices have in common",
     table(common_error_shape),
     [](Reader& r, const Place& p, SceneDraft& d) {
       read_common_errors(r, p, d.scene);
     },
     [](const SceneDraft& d) { return write_common_errors(d.scene); }},
    {"occluders", Need::optional, "what blocks the sight", list(occluder_shape),
     [](Reader& r, const Place& p, SceneDraft& d) {
       read_occluders(r, p, d.scene.occluders);
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.occluders.empty()) return std::nullopt;
       return write_occluders(d.scene.occluders);
     }},
    {"clutter", Need::optional, "what blocks the sight, drawn at random",
     table(clutter_shape),
     [](Reader& r, const Place& p, SceneDraft& d) {
       read_clutter(r, p, d.scene.clutter);
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.clutter.empty()) return std::nullopt;
       return write_clutter(d.scene.clutter);
     }},
    {"skin", Need::optional,
     "how near to the ends of a sight line nothing hides, metres",
     number("m", at_least(0)),
     [](Reader& r, const Place& p, SceneDraft& d) {
       if (const auto skin = r.number(p)) d.scene.skin = *skin;
     },
     [](const SceneDraft& d) -> Written {
       if (d.scene.skin == Scene{}.skin) return std::nullopt;
       return to_node(d.scene.skin);
     }},
    // Read last, by read_search(): they are about the whole scene.
    {"variables", Need::optional, "what a search may change", list(variable_shape),
     nullptr, [](const SceneDraft& d) { return write_variables(d.scene); }},
    {"constraints", Need::optional, "what a search must keep", list(constraint_shape),
     nullptr, [](const SceneDraft& d) { return write_constraints(d.scene); }},
    {"objective", Need::optional, "what a search makes small", either(objective_forms),
     nullptr, [](const SceneDraft& d) { return write_objective(d.scene); }},
    {"selection", Need::optional, "what can be chosen, and how much of it",
     map(selection_keys), nullptr,
     [](const SceneDraft& d) { return write_selection(d.scene); }},
}};

/// Two devices whose rates differ, or null.
std::pair<const DeviceEntry*, const DeviceEntry*> different_rates(const Scene& scene) {
  for (const DeviceEntry& device : scene.devices)
    if (rate_of(device) != rate_of(scene.devices.front()))
      return {&scene.devices.front(), &device};
  return {nullptr, nullptr};
}

std::string rates_text(const DeviceEntry& a, const DeviceEntry& b) {
  return a.name + " has " + shortest(rate_of(a)) + " Hz and " + b.name + " has " +
         shortest(rate_of(b)) + " Hz";
}

/// Fusion, motion and rates must fit together.
void check_fusion(Reader& reader, const Place& root, const Scene& scene) {
  const auto [a, b] = different_rates(scene);
  const Node* given = root.node().find("fusion");
  const auto refuse = [&](const std::string& problem) {
    // Where fusion isn't given, the type of motion is what leaves no choice.
    const Node* motion = root.node().find("motion");
    reader.error_within(root, given ? given->mark : motion->mark,
                        given ? "fusion" : "motion", problem);
  };
  const bool custom = !scene.motion.in_continuous_time();
  if (scene.fusion == Fusion::stacked && a)
    refuse("stacked needs one rate, but " + rates_text(*a, *b) +
           (custom ? "; make them equal" : "; use continuous or periodic"));
  if (!custom) return;
  if (scene.fusion == Fusion::continuous || scene.fusion == Fusion::periodic)
    refuse(
        std::string(to_string(*scene.fusion)) +
        " needs a motion in continuous time, which custom motion isn't; use stacked");
  else if (a && (!scene.fusion || scene.fusion == Fusion::artemis ||
                 scene.fusion == Fusion::sequential))
    refuse("custom motion is one update of one rate, but " + rates_text(*a, *b) +
           "; make them equal");
}

/// Variables may not part rates that must be one.
void check_varied_rates(Reader& reader, const Place& root, const Scene& scene) {
  if (has_one_rate(scene)) return;
  const bool custom = !scene.motion.in_continuous_time();
  if (!custom && scene.fusion != Fusion::stacked) return;
  const std::string why = custom ? "custom motion is one update of one rate"
                                 : "stacked fusion needs one rate";
  reader.error_within(root, root.node().find("variables")->mark, "variables",
                      "change the rates of single devices, but " + why +
                          (custom ? "; tie all rates together"
                                  : "; tie all rates together, or use continuous"));
}

/// Not every fusion, nor every motion, knows of readings that take time.
void check_exposures(Reader& reader, const Place& root, const Scene& scene) {
  const std::string problem = exposure_problem(scene.motion, definition_of(scene));
  if (problem.empty()) return;
  for (std::size_t i = 0; i < scene.devices.size(); ++i) {
    const DeviceEntry& device = scene.devices[i];
    const Node* given = root.node().find("devices")->items[i].find("exposure");
    if (given && device.exposure > 0)
      reader.error_within(root, given->mark, "devices." + device.name + ".exposure",
                          problem);
  }
}

/// Nor may variables make readings take time where that isn't known.
void check_varied_exposures(Reader& reader, const Place& root, const Scene& scene) {
  const std::string problem = exposure_problem(scene.motion, definition_of(scene));
  if (!problem.empty() && varies_exposures(scene))
    reader.error_within(root, root.node().find("variables")->mark, "variables",
                        "change an exposure, which " + problem);
}

/// Nor can everything be carried on for a while.
void check_lag(Reader& reader, const Place& root, const Scene& scene) {
  const std::string problem = lag_problem(scene.motion, definition_of(scene));
  if (scene.lag > 0 && !problem.empty())
    reader.error_within(root, root.node().find("lag")->mark, "lag", problem);
}

/// Orientations stand in `sample` or beside it, not in both.
void check_orientations(Reader& reader, const Place& root) {
  const Node* beside = root.node().find("orientations");
  const Node* sample = root.node().find("sample");
  if (beside && sample && sample->find("orientations"))
    reader.error_within(root, beside->mark, "orientations",
                        "are given inside 'sample' already; keep one");
}

/// Where no metric is given, the usual one must be one of the state.
void check_usual_metric(Reader& reader, const Place& root, const SceneDraft& draft) {
  if (root.node().find("metric") || !draft.known.motion || !draft.metrics_known) return;
  const auto usual = parse_metric(draft.scene.metric, known_metrics(draft.scene));
  if (const auto* problem = std::get_if<std::string>(&usual))
    reader.error_within(
        root, root.node().find("motion")->mark, "motion",
        "has no pose for the usual metric; name another in 'metric': " + *problem);
}

/// The value that samples gather around is one of the metric, which is known only now.
void read_near_metric(Reader& reader, const Place& root, SceneDraft& draft) {
  const Node* sample = root.node().find("sample");
  if (!sample || !draft.known.motion) return;
  const auto metric = parse_metric(draft.scene.metric, known_metrics(draft.scene));
  if (const auto* known = std::get_if<Metric>(&metric))
    read_near(reader, Place(root, "sample", *sample), known->unit, draft.scene);
}

/// What a search is told names parts of the scene, so that these must be in order.
void read_search(Reader& reader, const Place& root, Scene& scene) {
  using Read = void (*)(Reader&, const Place&, Scene&);
  for (const auto& [key, read] :
       {std::pair<const char*, Read>{"variables", read_variables},
        {"constraints", read_constraints},
        {"objective", read_objective},
        {"selection", read_selection}}) {
    const Node* node = root.node().find(key);
    if (node && node->kind != Node::Kind::null)
      read(reader, Place(root, key, *node), scene);
  }
}

}  // namespace

Scene read_scene(Reader& reader, const Node& root) {
  SceneDraft draft;
  const Place place(root);
  if (root.kind == Node::Kind::null) {
    reader.error(place, "the scene is empty; begin the file with 'delos: 1'");
    return {};
  }
  if (!read_map(reader, place, kSceneKeys, draft)) return {};
  check_orientations(reader, place);
  check_usual_metric(reader, place, draft);
  read_near_metric(reader, place, draft);
  const bool rates_known =
      !draft.scene.devices.empty() &&
      std::all_of(draft.scene.devices.begin(), draft.scene.devices.end(),
                  [](const DeviceEntry& d) { return rate_of(d) > 0; });
  if (draft.known.motion && rates_known) {
    check_fusion(reader, place, draft.scene);
    check_exposures(reader, place, draft.scene);
    check_clocks(reader, place, draft.scene);
    check_lag(reader, place, draft.scene);
    check_calibrations(reader, place, draft.scene);
  }
  if (reader.findings.errors() > 0) return std::move(draft.scene);
  if (const Node* occluders = root.find("occluders"))
    find_rooms(reader, Place(place, "occluders", *occluders), draft.scene);
  read_search(reader, place, draft.scene);
  if (reader.findings.errors() == 0) check_varied_rates(reader, place, draft.scene);
  if (reader.findings.errors() == 0) {
    // Varied rates may have made the fusion another one.
    check_exposures(reader, place, draft.scene);
    check_clocks(reader, place, draft.scene);
    check_calibrations(reader, place, draft.scene);
    check_varied_exposures(reader, place, draft.scene);
  }
  return std::move(draft.scene);
}

std::vector<KeyShape> scene_keys() { return keys_of<kSceneKeys>(); }

Node scene_node(const Scene& scene) {
  return write_map(kSceneKeys, SceneDraft{scene, {}, true});
}

}  // namespace delos
