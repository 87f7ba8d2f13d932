#include <algorithm>
#include <numbers>
#include <set>

#include "delos/model/metric.h"
#include "delos/scene/definition.h"
#include "delos/scene/number.h"
#include "document/node_text.h"
#include "scene/search_keys.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

/// A constraint while it is read: the keys that kinds share stand beside them.
struct ConstraintDraft {
  Scene* scene = nullptr;
  ConstraintEntry entry;
  std::string kind;  ///< the key that gave it
  std::vector<std::string> devices;
  std::optional<double> margin, distance, limit;
  std::optional<Eigen::Vector3d> from;
  std::string in;
};

void read_region(Reader& reader, const Place& at, ConstraintDraft& out, bool outside) {
  const auto name = reader.word(at);
  if (!name) return;
  std::vector<std::string> known;
  for (const RegionEntry& region : out.scene->regions) known.push_back(region.name);
  if (std::find(known.begin(), known.end(), *name) == known.end())
    reader.error(at, "there is no region '" + *name + '\'' +
                         (known.empty() ? "; the scene declares none"
                                        : suggestion(*name, known)));
  out.entry.what = KeepInside{{}, *name, outside, 0};
}

void read_clear(Reader& reader, const Place& at, ConstraintDraft& out) {
  const auto ends = reader.vectors3(at, "m");
  if (!ends) return;
  if (ends->size() != 2 || (*ends)[0] == (*ends)[1])
    reader.error(at, "expected the two ends of a line [[x, y, z], [x, y, z]]");
  else
    out.entry.what = KeepClear{{}, (*ends)[0], (*ends)[1], 0};
}

void read_sum(Reader& reader, const Place& at, ConstraintDraft& out) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of paths to factors")) return;
  KeepSum sum;
  for (std::size_t i = 0; i < at.node().items.size(); ++i) {
    const std::string& pattern = at.node().keys[i].text;
    const auto factor = reader.number(Place(at, pattern, at.node().items[i]), "1");
    const auto paths = expand_numbers(*out.scene, pattern, reader.plugins);
    if (const auto* problem = std::get_if<std::string>(&paths)) {
      reader.error_within(at, at.node().keys[i].mark, pattern, *problem);
    } else if (factor) {
      for (const std::string& path : std::get<0>(paths))
        sum.factors.emplace_back(path, *factor);
    }
  }
  out.entry.what = std::move(sum);
}

void read_metric(Reader& reader, const Place& at, ConstraintDraft& out) {
  if (auto name = read_metric_name(reader, at, *out.scene))
    out.entry.what = KeepMetric{*std::move(name), {}, 0};
}

void read_limit(Reader& reader, const Place& at, ConstraintDraft& out) {
  std::string unit = "1";
  if (const auto* metric = std::get_if<KeepMetric>(&out.entry.what)) {
    if (metric->metric.empty()) return;
    unit =
        std::get<Metric>(parse_metric(metric->metric, known_metrics(*out.scene))).unit;
  }
  out.limit = reader.number(at, unit);
}

template <class Kind>
const Kind* as(const ConstraintDraft& draft) {
  return std::get_if<Kind>(&draft.entry.what);
}

Written write_region(const ConstraintDraft& d, bool outside) {
  const auto* inside = as<KeepInside>(d);
  if (!inside || inside->outside != outside) return std::nullopt;
  return to_node(inside->region);
}

Written write_devices(const ConstraintDraft& d) {
  return std::visit(
      [](const auto& what) -> Written {
        if constexpr (requires { what.devices; }) return names_node(what.devices);
        return std::nullopt;
      },
      d.entry.what);
}

constexpr Bounds kTilt = {
    .least = 0, .greatest = std::numbers::pi, .above = true, .below = true};

// What a kind needs to know of the others is read first.
constexpr std::array<Key<ConstraintDraft>, 16> kConstraintKeys = {{
    {"name", Need::optional, "what messages call it", name(),
     [](Reader& r, const Place& p, ConstraintDraft& d) {
       if (auto name = r.name(p)) d.entry.name = std::move(*name);
     },
     [](const ConstraintDraft& d) -> Written { return to_node(d.entry.name); }},
    {"inside", Need::optional, "a region that devices stay in", text(),
     [](Reader& r, const Place& p, ConstraintDraft& d) { read_region(r, p, d, false); },
     [](const ConstraintDraft& d) { return write_region(d, false); }},
    {"outside", Need::optional, "a region that devices keep away from", text(),
     [](Reader& r, const Place& p, ConstraintDraft& d) { read_region(r, p, d, true); },
     [](const ConstraintDraft& d) { return write_region(d, true); }},
    {"spacing", Need::optional, "the least distance of any two devices, metres",
     number("m", above(0)),
     [](Reader& r, const Place& p, ConstraintDraft& d) {
       d.entry.what = KeepApart{{}, r.number(p).value_or(0)};
     },
     [](const ConstraintDraft& d) -> Written {
       if (const auto* apart = as<KeepApart>(d)) return to_node(apart->distance);
       return std::nullopt;
     }},
    {"tilt", Need::optional, "the greatest angle of devices' z axes from a direction",
     number("rad", kTilt),
     [](Reader& r, const Place& p, ConstraintDraft& d) {
       KeepTilt tilt;
       tilt.angle = r.number(p).value_or(0);
       d.entry.what = tilt;
     },
     [](const ConstraintDraft& d) -> Written {
       if (const auto* tilt = as<KeepTilt>(d)) return to_node(tilt->angle);
       return std::nullopt;
     }},
    {"clear", Need::optional, "a line [[x, y, z], [x, y, z]] that devices keep off",
     list([] { return vector("m"); }, 2, 2), read_clear,
     [](const ConstraintDraft& d) -> Written {
       const auto* clear = as<KeepClear>(d);
       if (!clear) return std::nullopt;
       return to_node(std::vector<Eigen::Vector3d>{clear->from, clear->to});
     }},
    {"sum", Need::optional, "factors of numbers, by path, whose sum is limited",
     table([] { return number("1"); }), read_sum,
     [](const ConstraintDraft& d) -> Written {
       const auto* sum = as<KeepSum>(d);
       if (!sum) return std::nullopt;
       Node map;
       map.kind = Node::Kind::map;
       for (const auto& [path, factor] : sum->factors) {
         map.keys.push_back({path, {}});
         map.items.push_back(to_node(factor));
       }
       return map;
     }},
    {"metric", Need::optional, "a metric that is limited at every sample", text(),
     read_metric,
     [](const ConstraintDraft& d) -> Written {
       if (const auto* metric = as<KeepMetric>(d)) return to_node(metric->metric);
       return std::nullopt;
     }},
    {"devices", Need::optional, "the devices that it is about; * is any part of a name",
     names(),
     [](Reader& r, const Place& p, ConstraintDraft& d) {
       d.devices = read_device_names(r, p, *d.scene);
     },
     write_devices},
    {"margin", Need::optional,
     "of inside and outside: how far from the surface, metres", number("m"),
     [](Reader& r, const Place& p, ConstraintDraft& d) { d.margin = r.number(p); },
     [](const ConstraintDraft& d) -> Written {
       if (const auto* inside = as<KeepInside>(d)) return to_node(inside->margin);
       return std::nullopt;
     }},
    {"distance", Need::optional, "of clear: how far devices keep off, metres",
     number("m", above(0)),
     [](Reader& r, const Place& p, ConstraintDraft& d) { d.distance = r.number(p); },
     [](const ConstraintDraft& d) -> Written {
       if (const auto* clear = as<KeepClear>(d)) return to_node(clear->distance);
       return std::nullopt;
     }},
    {"from", Need::optional, "of tilt: the direction; default: down, [0, 0, -1]",
     vector("1"),
     [](Reader& r, const Place& p, ConstraintDraft& d) {
       d.from = r.vector3(p, "1");
       if (d.from && d.from->isZero(0)) r.error(p, "is no direction");
     },
     [](const ConstraintDraft& d) -> Written {
       if (const auto* tilt = as<KeepTilt>(d)) return vector_node(tilt->from);
       return std::nullopt;
     }},
    {"at_most", Need::optional, "of sum: the limit", number(nullptr), read_limit,
     [](const ConstraintDraft& d) -> Written {
       if (const auto* sum = as<KeepSum>(d)) return to_node(sum->limit);
       return std::nullopt;
     }},
    {"below", Need::optional, "of metric: the limit, where less is better",
     number(nullptr), read_limit,
     [](const ConstraintDraft& d) -> Written {
       const auto* metric = as<KeepMetric>(d);
       if (!metric || d.kind == "above") return std::nullopt;
       return to_node(metric->limit);
     }},
    {"above", Need::optional, "of metric: the limit, where more is better",
     number(nullptr), read_limit,
     [](const ConstraintDraft& d) -> Written {
       const auto* metric = as<KeepMetric>(d);
       if (!metric || d.kind != "above") return std::nullopt;
       return to_node(metric->limit);
     }},
    {"in", Need::optional, "of metric: a sample set; default: all samples", text(),
     [](Reader& r, const Place& p, ConstraintDraft& d) {
       const auto name = r.word(p);
       if (!name) return;
       std::vector<std::string> known;
       for (const SampleSet& set : d.scene->samples)
         if (!set.name.empty()) known.push_back(set.name);
       if (std::find(known.begin(), known.end(), *name) == known.end())
         r.error(p, "there is no sample set '" + *name + '\'' +
                        (known.empty() ? "; no set of the scene has a name"
                                       : suggestion(*name, known)));
       d.in = *name;
     },
     [](const ConstraintDraft& d) -> Written {
       const auto* metric = as<KeepMetric>(d);
       if (!metric || metric->in.empty()) return std::nullopt;
       return to_node(metric->in);
     }},
}};

/// Which other keys a kind needs, and may have.
struct Kind {
  const char* name;
  std::vector<std::string> needs, may;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> kKinds = {
      {"inside", {"devices"}, {"margin"}},
      {"outside", {"devices"}, {"margin"}},
      {"spacing", {"devices"}, {}},
      {"tilt", {"devices"}, {"from"}},
      {"clear", {"devices", "distance"}, {}},
      {"sum", {"at_most"}, {}},
      {"metric", {}, {"below", "above", "in"}},
  };
  return kKinds;
}

/// Exactly one kind, with its own keys.
bool check_keys(Reader& reader, const Place& at, ConstraintDraft& draft) {
  const std::size_t before = reader.findings.errors();
  const Kind* given = nullptr;
  for (const Kind& kind : kinds()) {
    const Node* node = at.node().find(kind.name);
    if (!node) continue;
    if (given)
      reader.error_within(at, node->mark, kind.name,
                          std::string("the constraint is '") + given->name +
                              "' already; make a list of two");
    given = &kind;
  }
  if (!given) {
    reader.error(at,
                 "keeps nothing; give inside, outside, spacing, tilt, clear, sum or "
                 "metric");
    return false;
  }
  draft.kind = given->name;
  for (const std::string& need : given->needs)
    if (!at.node().find(need))
      reader.error_within(at, at.node().mark, need, "missing for " + draft.kind);
  std::set<std::string> mine(given->needs.begin(), given->needs.end());
  mine.insert(given->may.begin(), given->may.end());
  mine.insert({"name", draft.kind});
  for (const Node::Key& key : at.node().keys)
    if (!mine.count(key.text))
      reader.error_within(at, key.mark, key.text, "isn't for " + draft.kind);
  return reader.findings.errors() == before;
}

void check_metric(Reader& reader, const Place& at, const ConstraintDraft& draft) {
  const auto* metric = as<KeepMetric>(draft);
  if (!metric) return;
  const bool more =
      std::get<Metric>(parse_metric(metric->metric, known_metrics(*draft.scene)))
          .larger_is_better;
  const char* wanted = more ? "above" : "below";
  const char* wrong = more ? "below" : "above";
  if (const Node* node = at.node().find(wrong))
    reader.error_within(
        at, node->mark, wrong,
        (more ? "more " : "less ") + metric->metric + " is better: give " + wanted);
  else if (!at.node().find(wanted))
    reader.error_within(at, at.node().mark, wanted, "missing for metric");
}

/// What was read beside the kind goes into it.
void complete(ConstraintDraft& draft) {
  std::visit(
      [&](auto& what) {
        if constexpr (requires { what.devices; }) what.devices = draft.devices;
        if constexpr (requires { what.margin; }) what.margin = draft.margin.value_or(0);
      },
      draft.entry.what);
  if (auto* clear = std::get_if<KeepClear>(&draft.entry.what))
    clear->distance = draft.distance.value_or(0);
  if (auto* tilt = std::get_if<KeepTilt>(&draft.entry.what); tilt && draft.from)
    tilt->from = *draft.from;
  if (auto* sum = std::get_if<KeepSum>(&draft.entry.what))
    sum->limit = draft.limit.value_or(0);
  if (auto* metric = std::get_if<KeepMetric>(&draft.entry.what)) {
    metric->limit = draft.limit.value_or(0);
    metric->in = draft.in;
  }
}

}  // namespace

Shape constraint_shape() { return map<kConstraintKeys>(); }

std::vector<std::string> read_device_names(Reader& reader, const Place& at,
                                           const Scene& scene) {
  std::vector<std::string> patterns;
  if (at.node().kind == Node::Kind::list) {
    for (const Node& item : at.node().items) patterns.push_back(item.text);
  } else if (const auto word = reader.word(at)) {
    patterns.push_back(*word);
  }
  if (patterns.empty()) return {};
  auto names = expand_devices(scene, patterns);
  if (const auto* problem = std::get_if<std::string>(&names)) {
    reader.error(at, *problem);
    return {};
  }
  return std::get<0>(std::move(names));
}

void read_constraints(Reader& reader, const Place& at, Scene& scene) {
  if (!reader.expect(at, Node::Kind::list, "a list of constraints")) return;
  std::set<std::string> names;
  for (std::size_t i = 0; i < at.node().items.size(); ++i) {
    const Place place(at, member_name(at.node().items[i], i), at.node().items[i]);
    ConstraintDraft draft;
    draft.scene = &scene;
    const std::size_t before = reader.findings.errors();
    if (!read_map(reader, place, kConstraintKeys, draft)) continue;
    if (reader.findings.errors() != before || !check_keys(reader, place, draft))
      continue;
    check_metric(reader, place, draft);
    complete(draft);
    if (draft.entry.name.empty())
      draft.entry.name = draft.kind + "_" + std::to_string(i);
    if (!names.insert(draft.entry.name).second)
      reader.error_within(
          place, place.node().mark, "name",
          '\'' + draft.entry.name + "' is another constraint's name already");
    scene.constraints.push_back(std::move(draft.entry));
  }
}

std::optional<Node> write_constraints(const Scene& scene) {
  if (scene.constraints.empty()) return std::nullopt;
  std::vector<Node> list;
  for (const ConstraintEntry& entry : scene.constraints) {
    ConstraintDraft draft;
    draft.entry = entry;
    if (const auto* metric = std::get_if<KeepMetric>(&entry.what)) {
      const auto known = parse_metric(metric->metric, known_metrics(scene));
      if (std::get<Metric>(known).larger_is_better) draft.kind = "above";
    }
    list.push_back(write_map(kConstraintKeys, draft));
  }
  return to_node(std::move(list));
}

}  // namespace delos
