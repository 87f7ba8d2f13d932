#include <algorithm>

#include "delos/sampling/samples.h"
#include "delos/scene/candidates.h"
#include "delos/scene/number.h"
#include "delos/text/numbers.h"
#include "delos/text/units.h"
#include "document/node_text.h"
#include "scene/sample_shapes.h"
#include "scene/search_keys.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

constexpr std::pair<const char*, BeaconGrouping> kGroupingWords[] = {
    {"beacon", BeaconGrouping::beacon},
    {"row", BeaconGrouping::row},
    {"column", BeaconGrouping::column},
    {"panel", BeaconGrouping::panel}};

/// A set of candidates while it is read: the keys of a kind stand beside it.
struct CandidateDraft {
  const Scene* scene = nullptr;
  CandidateSet set;
  std::string kind;  ///< the key that gave it
  std::vector<int> counts;
};

template <class Kind>
Kind* as(CandidateDraft& draft) {
  return std::get_if<Kind>(&draft.set.what);
}
template <class Kind>
const Kind* as(const CandidateDraft& draft) {
  return std::get_if<Kind>(&draft.set.what);
}

/// One word, or a list of words.
std::vector<std::string> read_words(Reader& reader, const Place& at) {
  std::vector<std::string> words;
  if (at.node().kind != Node::Kind::list) {
    if (auto word = reader.word(at)) words.push_back(std::move(*word));
    return words;
  }
  for (std::size_t i = 0; i < at.node().items.size(); ++i)
    if (auto word = reader.word(Place(at, std::to_string(i), at.node().items[i])))
      words.push_back(std::move(*word));
  if (at.node().items.empty()) reader.error(at, "the list is empty; leave it out");
  return words;
}

Node words_node(const std::vector<std::string>& words) {
  std::vector<Node> list;
  for (const std::string& word : words) list.push_back(to_node(word));
  return to_node(std::move(list));
}

template <class Kind>
void begin(Reader& reader, const Place& at, const char* key, CandidateDraft& out,
           Kind kind) {
  if (!out.kind.empty())
    reader.error(at, "the candidates are given by '" + out.kind +
                         "' already; write "
                         "another entry of the list for these");
  out.kind = key;
  out.set.what = std::move(kind);
}

void read_devices(Reader& reader, const Place& at, CandidateDraft& out) {
  CandidateDevices devices;
  const std::vector<std::string> patterns = read_words(reader, at);
  if (!patterns.empty()) {
    auto names = expand_devices(*out.scene, patterns);
    if (const auto* problem = std::get_if<std::string>(&names))
      reader.error(at, *problem);
    else
      devices.devices = std::get<0>(std::move(names));
  }
  begin(reader, at, "devices", out, std::move(devices));
}

template <class Entry>
void check_name(Reader& reader, const Place& at, const std::vector<Entry>& entries,
                const std::string& name, const char* what) {
  std::vector<std::string> known;
  for (const Entry& entry : entries) known.push_back(entry.name);
  if (std::find(known.begin(), known.end(), name) == known.end())
    reader.error(at, std::string("there is no ") + what + " '" + name + '\'' +
                         (known.empty() ? "; the scene declares none"
                                        : suggestion(name, known)));
}

void read_beacon_set(Reader& reader, const Place& at, CandidateDraft& out) {
  CandidateBeacons beacons;
  if (auto name = reader.word(at)) {
    check_name(reader, at, out.scene->beacons, *name, "set of beacons");
    beacons.set = std::move(*name);
  }
  begin(reader, at, "beacons", out, std::move(beacons));
}

void read_copies(Reader& reader, const Place& at, CandidateDraft& out) {
  CandidateCopies copies;
  if (auto name = reader.word(at)) {
    check_name(reader, at, out.scene->devices, *name, "device");
    for (const DeviceEntry& device : out.scene->devices)
      if (device.name == *name && device.mount == Mount::target)
        reader.error(at, "is carried by the target; copies stand in the world");
    copies.of = std::move(*name);
  }
  begin(reader, at, "copies_of", out, std::move(copies));
}

/// Something that says more about a kind. Null, with a finding, where it is another.
template <class Kind>
Kind* part_of(Reader& reader, const Place& at, CandidateDraft& out, const char* of) {
  Kind* kind = as<Kind>(out);
  if (!kind || out.kind != of) {
    reader.error(at, std::string("is of '") + of + "', which isn't given");
    return nullptr;
  }
  return kind;
}

void read_by(Reader& reader, const Place& at, CandidateDraft& out) {
  auto* beacons = part_of<CandidateBeacons>(reader, at, out, "beacons");
  const auto by = reader.choice(at, kGroupingWords);
  if (!beacons || !by) return;
  beacons->by = *by;
  for (const BeaconSet& set : out.scene->beacons)
    if (set.name == beacons->set && *by != BeaconGrouping::beacon &&
        !std::holds_alternative<BeaconGrid>(set.layout))
      reader.error(at, "rows, columns and panels are of a grid; use beacon");
}

void read_spots(Reader& reader, const Place& at, CandidateDraft& out, const char* key) {
  auto* copies = part_of<CandidateCopies>(reader, at, out, "copies_of");
  if (!copies) return;
  const std::string kind = key;
  if (kind == "grid") {
    const auto volume = read_volume(reader, at);
    if (!volume) return;
    if (const auto* grid = std::get_if<VolumeSampling>(&*volume))
      copies->spots = *grid;
    else
      reader.error(at, "spots stand on a grid; give 'step'");
  } else if (kind == "points") {
    if (auto points = reader.vectors3(at, "m")) copies->spots = std::move(*points);
  } else if (auto name = reader.word(at)) {
    check_name(reader, at, out.scene->surfaces, *name, "surface");
    copies->spots = SurfaceSpots{std::move(*name), {}};
  }
}

void read_counts(Reader& reader, const Place& at, CandidateDraft& out) {
  auto* copies = part_of<CandidateCopies>(reader, at, out, "copies_of");
  auto* on = copies ? std::get_if<SurfaceSpots>(&copies->spots) : nullptr;
  if (copies && !on) reader.error(at, "is of 'surface', which isn't given");
  if (!on || !reader.expect(at, Node::Kind::list, "a list of whole numbers")) return;
  for (std::size_t i = 0; i < at.node().items.size(); ++i)
    if (const auto n =
            reader.integer(Place(at, std::to_string(i), at.node().items[i]), 1, 100000))
      on->counts.push_back(*n);
  for (const SurfaceEntry& surface : out.scene->surfaces) {
    if (surface.name != on->surface) continue;
    const std::size_t wanted =
        std::holds_alternative<RailSurface>(surface.shape) ? 1 : 2;
    if (at.node().items.size() != wanted)
      reader.error(at,
                   wanted == 1 ? "a rail has one count" : "a surface has two counts");
  }
}

template <auto kMember>
void read_facings(Reader& reader, const Place& at, CandidateDraft& out) {
  auto* copies = part_of<CandidateCopies>(reader, at, out, "copies_of");
  if (!copies) return;
  auto& list = copies->facings.*kMember;
  if constexpr (std::is_same_v<decltype(list), std::vector<double>&>) {
    if (!reader.expect(at, Node::Kind::list, "a list of angles")) return;
    for (std::size_t i = 0; i < at.node().items.size(); ++i)
      if (const auto angle =
              reader.number(Place(at, std::to_string(i), at.node().items[i]), "rad"))
        list.push_back(*angle);
    if (at.node().items.empty()) reader.error(at, "the list is empty; leave it out");
  } else {
    constexpr bool kOfAngles = kMember == &Facings::rpy;
    if (auto vectors =
            kOfAngles ? reader.vectors3(at, "rad", kAngles) : reader.vectors3(at, "m"))
      list = std::move(*vectors);
  }
}

template <class Kind>
Written write_copies(const CandidateDraft& d, Written (*write)(const Kind&)) {
  const auto* copies = as<CandidateCopies>(d);
  const auto* kind = copies ? std::get_if<Kind>(&copies->spots) : nullptr;
  return kind ? write(*kind) : std::nullopt;
}

template <auto kMember>
Written write_facings(const CandidateDraft& d) {
  const auto* copies = as<CandidateCopies>(d);
  if (!copies || (copies->facings.*kMember).empty()) return std::nullopt;
  const auto& list = copies->facings.*kMember;
  if constexpr (std::is_same_v<decltype(list), const std::vector<double>&>) {
    std::vector<Node> nodes;
    for (const double angle : list) nodes.push_back(to_node(angle));
    return to_node(std::move(nodes));
  } else {
    return to_node(list);
  }
}

// What a kind needs to know is read first.
constexpr std::array<Key<CandidateDraft>, 14> kCandidateKeys = {{
    {"devices", Need::optional, "devices of the scene; * is any part of a name",
     names(), read_devices,
     [](const CandidateDraft& d) -> Written {
       const auto* devices = as<CandidateDevices>(d);
       return devices ? Written(words_node(devices->devices)) : std::nullopt;
     }},
    {"beacons", Need::optional, "a set of beacons", text(), read_beacon_set,
     [](const CandidateDraft& d) -> Written {
       const auto* beacons = as<CandidateBeacons>(d);
       return beacons ? Written(to_node(beacons->set)) : std::nullopt;
     }},
    {"by", Need::optional,
     "what is chosen of the beacons as one: beacon, row, column or panel",
     choice<kGroupingWords>(), read_by,
     [](const CandidateDraft& d) -> Written {
       const auto* beacons = as<CandidateBeacons>(d);
       if (!beacons) return std::nullopt;
       for (const auto& [word, by] : kGroupingWords)
         if (by == beacons->by) return to_node(word);
       return std::nullopt;
     }},
    {"copies_of", Need::optional,
     "a device of which copies may stand at many spots; it is only their pattern",
     text(), read_copies,
     [](const CandidateDraft& d) -> Written {
       const auto* copies = as<CandidateCopies>(d);
       return copies ? Written(to_node(copies->of)) : std::nullopt;
     }},
    {"grid", Need::optional, "spots on a regular grid: min, max and step, metres",
     map(volume_keys),
     [](Reader& r, const Place& p, CandidateDraft& d) { read_spots(r, p, d, "grid"); },
     [](const CandidateDraft& d) {
       return write_copies<VolumeSampling>(
           d, [](const VolumeSampling& g) -> Written { return write_volume(g); });
     }},
    {"points", Need::optional, "spots one by one, [[x, y, z], …], metres", points(),
     [](Reader& r, const Place& p, CandidateDraft& d) {
       read_spots(r, p, d, "points");
     },
     [](const CandidateDraft& d) {
       return write_copies<std::vector<Eigen::Vector3d>>(
           d, [](const std::vector<Eigen::Vector3d>& v) -> Written {
             if (v.empty()) return std::nullopt;
             return to_node(v);
           });
     }},
    {"surface", Need::optional, "a surface with spots spread over it", text(),
     [](Reader& r, const Place& p, CandidateDraft& d) {
       read_spots(r, p, d, "surface");
     },
     [](const CandidateDraft& d) {
       return write_copies<SurfaceSpots>(
           d, [](const SurfaceSpots& s) -> Written { return to_node(s.surface); });
     }},
    {"counts", Need::optional, "spots of a surface along u and v, or along a rail",
     numbers("1", 1, 2, between(1, 100000)), read_counts,
     [](const CandidateDraft& d) {
       return write_copies<SurfaceSpots>(d, [](const SurfaceSpots& s) -> Written {
         std::vector<Node> list;
         for (const int n : s.counts) list.push_back(to_node(n));
         return to_node(std::move(list));
       });
     }},
    {"aims", Need::optional, "points that the z axis looks at from every spot, metres",
     points(), read_facings<&Facings::aims>, write_facings<&Facings::aims>},
    {"rpy", Need::optional, "orientations at every spot, [[roll, pitch, yaw], …]",
     list([] { return vector("rad"); }, 1), read_facings<&Facings::rpy>,
     write_facings<&Facings::rpy>},
    {"pans", Need::optional, "turns about the world's z from its x axis, with `tilts`",
     numbers("rad", 1), read_facings<&Facings::pans>, write_facings<&Facings::pans>},
    {"tilts", Need::optional, "angles above the horizon, each with every pan",
     numbers("rad", 1), read_facings<&Facings::tilts>, write_facings<&Facings::tilts>},
    {"one_per_spot", Need::optional,
     "whether at most one of a spot's facings is chosen: yes (default) or no",
     choice<kTruthWords>(),
     [](Reader& r, const Place& p, CandidateDraft& d) {
       auto* copies = part_of<CandidateCopies>(r, p, d, "copies_of");
       const auto one = r.choice(p, kTruthWords);
       if (copies && one) copies->one_per_spot = *one;
     },
     [](const CandidateDraft& d) -> Written {
       const auto* copies = as<CandidateCopies>(d);
       if (!copies || copies->one_per_spot) return std::nullopt;
       return to_node("no");
     }},
    {"cost", Need::optional, "what each costs, in any unit; 1", number("1", above(0)),
     [](Reader& r, const Place& p, CandidateDraft& d) {
       if (const auto cost = r.number(p)) d.set.cost = *cost;
     },
     [](const CandidateDraft& d) -> Written {
       if (d.set.cost == 1) return std::nullopt;
       return to_node(d.set.cost);
     }},
}};

/// Of one set: each is a device of its own.
constexpr double kMostCandidates = 1'000'000;

/// How many copies a set asks for, before any is made.
double count_of(const CandidateCopies& copies) {
  double spots = 1;
  if (const auto* points = std::get_if<std::vector<Eigen::Vector3d>>(&copies.spots))
    spots = static_cast<double>(points->size());
  else if (const auto* grid = std::get_if<VolumeSampling>(&copies.spots))
    spots = static_cast<double>(sample_count({{}, *grid}));
  else
    for (const int n : std::get<SurfaceSpots>(copies.spots).counts) spots *= n;
  const Facings& f = copies.facings;
  const auto facings =
      static_cast<double>(f.aims.size() + f.rpy.size()) +
      static_cast<double>(f.pans.size()) * static_cast<double>(f.tilts.size());
  return spots * std::max(1.0, facings);
}

/// What only the keys of a set together tell.
void check_set(Reader& reader, const Place& at, const CandidateDraft& draft) {
  if (draft.kind.empty())
    return reader.error(at, "no candidates; give devices, beacons or copies_of");
  const auto* copies = as<CandidateCopies>(draft);
  if (!copies) return;
  const Node& node = at.node();
  const auto given = [&](std::initializer_list<const char*> keys) {
    return std::count_if(keys.begin(), keys.end(),
                         [&](const char* key) { return node.find(key) != nullptr; });
  };
  if (given({"grid", "points", "surface"}) != 1)
    reader.error(at, "say where the copies may stand: one of grid, points and surface");
  if (node.find("surface") && !node.find("counts"))
    reader.error(at, "say how many spots the surface has: counts");
  if (given({"aims", "rpy", "pans"}) > 1 || given({"aims", "rpy", "tilts"}) > 1)
    reader.error(at,
                 "facings are given twice; keep one of aims, rpy, and pans with "
                 "tilts");
  if (given({"pans", "tilts"}) == 1)
    reader.error(at, "pans and tilts belong together; give both");
  if (const double count = count_of(*copies); count > kMostCandidates)
    reader.error(at, grouped(static_cast<std::int64_t>(std::min(count, 1e18))) +
                         " candidates; at most " +
                         grouped(static_cast<std::int64_t>(kMostCandidates)) +
                         ": make the grid coarser or the facings fewer");
}

void read_candidates(Reader& reader, const Place& at, Scene& scene) {
  if (!reader.expect(at, Node::Kind::list, "a list of sets of candidates")) return;
  const auto& items = at.node().items;
  if (items.empty()) reader.error(at, "the list is empty: there is nothing to choose");
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Place place(at, std::to_string(i), items[i]);
    CandidateDraft draft{&scene, {}, {}, {}};
    const std::size_t before = reader.findings.errors();
    if (!read_map(reader, place, kCandidateKeys, draft)) continue;
    if (reader.findings.errors() == before) check_set(reader, place, draft);
    scene.selection.candidates.push_back(std::move(draft.set));
  }
}

constexpr std::array<Key<Scene>, 6> kSelectionKeys = {{
    {"candidates", Need::required, "what can be chosen, a list",
     list([] { return map<kCandidateKeys>(); }, 1), read_candidates,
     [](const Scene& s) -> Written {
       std::vector<Node> list;
       for (const CandidateSet& set : s.selection.candidates)
         list.push_back(
             write_map(kCandidateKeys, CandidateDraft{nullptr, set, {}, {}}));
       return to_node(std::move(list));
     }},
    {"count", Need::optional, "choose at most so many", integer(1),
     [](Reader& r, const Place& p, Scene& s) { s.selection.count = r.integer(p); },
     [](const Scene& s) -> Written {
       if (!s.selection.count) return std::nullopt;
       return to_node(*s.selection.count);
     }},
    {"budget", Need::optional, "what the chosen ones may cost together",
     number("1", above(0)),
     [](Reader& r, const Place& p, Scene& s) { s.selection.budget = r.number(p); },
     [](const Scene& s) -> Written {
       if (!s.selection.budget) return std::nullopt;
       return to_node(*s.selection.budget);
     }},
    {"cover", Need::optional,
     "choose the cheapest that see every sample at least so often, whatever the "
     "accuracy",
     integer(1, 1000),
     [](Reader& r, const Place& p, Scene& s) { s.selection.cover = r.integer(p); },
     [](const Scene& s) -> Written {
       if (!s.selection.cover) return std::nullopt;
       return to_node(*s.selection.cover);
     }},
    {"keep", Need::optional,
     "candidates that are chosen anyway; * is any part of a name", names(),
     [](Reader& r, const Place& p, Scene& s) { s.selection.keep = read_words(r, p); },
     [](const Scene& s) -> Written {
       if (s.selection.keep.empty()) return std::nullopt;
       return words_node(s.selection.keep);
     }},
    {"leave_out", Need::optional, "candidates that aren't chosen", names(),
     [](Reader& r, const Place& p, Scene& s) {
       s.selection.leave_out = read_words(r, p);
     },
     [](const Scene& s) -> Written {
       if (s.selection.leave_out.empty()) return std::nullopt;
       return words_node(s.selection.leave_out);
     }},
}};

/// How much is chosen is said once, and what is kept fits into it.
void check_limits(Reader& reader, const Place& at, const Scene& scene,
                  const CandidateScene& all) {
  const Selection& selection = scene.selection;
  const int given = selection.count.has_value() + selection.budget.has_value() +
                    selection.cover.has_value();
  if (given != 1) {
    const char* last = selection.cover ? "cover" : "budget";
    const Node* node = given > 1 ? at.node().find(last) : &at.node();
    return reader.error_within(at, node->mark, given > 1 ? last : "count",
                               given > 1
                                   ? "keep one of count, budget and cover"
                                   : "missing: say how much may be chosen by count or "
                                     "budget, or what must be seen by cover");
  }
  int kept = 0;
  double cost = 0;
  for (const Candidate& c : all.candidates) {
    kept += c.kept;
    if (c.kept) cost += c.cost;
  }
  if (selection.count && kept > *selection.count)
    reader.error_within(at, at.node().find("count")->mark, "count",
                        std::to_string(kept) + " candidates are kept already");
  if (selection.budget && cost > *selection.budget)
    reader.error_within(
        at, at.node().find("budget")->mark, "budget",
        "the candidates that are kept cost " + shortest(cost) + " already");
}

}  // namespace

std::vector<KeyShape> selection_keys() { return keys_of<kSelectionKeys>(); }

void read_selection(Reader& reader, const Place& at, Scene& scene) {
  const std::size_t before = reader.findings.errors();
  if (!read_map(reader, at, kSelectionKeys, scene)) return;
  if (reader.findings.errors() != before) return;
  const auto all = write_out_candidates(scene);
  if (const auto* problem = std::get_if<std::string>(&all))
    return reader.error(at, *problem);
  check_limits(reader, at, scene, std::get<0>(all));
}

std::optional<Node> write_selection(const Scene& scene) {
  if (scene.selection.candidates.empty()) return std::nullopt;
  return write_map(kSelectionKeys, scene);
}

}  // namespace delos
