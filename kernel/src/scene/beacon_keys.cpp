#include "scene/beacon_keys.h"

#include <limits>
#include <numbers>

#include "delos/sampling/samples.h"
#include "delos/text/numbers.h"
#include "document/node_text.h"
#include "scene/point_file.h"
#include "scene/sample_limit.h"
#include "scene/sample_shapes.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

/// More would need gigabytes and are surely a slip in `step`.
constexpr std::int64_t kMostBeacons = 10'000'000;

/// A set as its keys say it: pattern and panel stand beside the grid that they are of.
struct BeaconSetDraft {
  BeaconSet set;
  std::optional<BeaconPattern> pattern;
  std::optional<Eigen::Vector2i> panel;
};

/// x, y, z, then the normal, then the weight.
const RowForm kRow = {{"x", "y", "z", "nx", "ny", "nz", "weight"}, {3, 6, 7}};

/// What a row lacks; empty where nothing is wrong.
std::string row_problem(const std::vector<double>& row) {
  if (row.size() >= 6 && Eigen::Vector3d(row[3], row[4], row[5]).isZero(0))
    return "the normal has length zero; leave it out where a beacon faces no way";
  if (row.size() == 7 && !(row[6] >= 0 && row[6] <= 1))
    return "the weight must be from 0 to 1";
  return "";
}

BeaconEntry entry_of(const std::vector<double>& row) {
  BeaconEntry entry{{row[0], row[1], row[2]}, std::nullopt, 1};
  if (row.size() >= 6) entry.normal.emplace(row[3], row[4], row[5]);
  if (row.size() == 7) entry.weight = row[6];
  return entry;
}

void read_grid(Reader& reader, const Place& at, BeaconSetDraft& out) {
  const auto volume = read_volume(reader, at);
  if (!volume) return;
  const auto* box = std::get_if<VolumeSampling>(&*volume);
  if (!box)
    return reader.error_within(at, at.node().find("adaptive")->mark, "adaptive",
                               "beacons stand on a grid; give 'step'");
  const std::int64_t count = sample_count({{}, *box});
  if (count > kMostBeacons)
    return reader.error_within(at, at.node().find("step")->mark, "step",
                               grouped(count) + " beacons; at most " +
                                   grouped(kMostBeacons) + ": make it coarser");
  out.set.layout = BeaconGrid{*box};
}

void read_list(Reader& reader, const Place& at, BeaconSetDraft& out) {
  if (!reader.expect(at, Node::Kind::list,
                     "a list of beacons [[x, y, z], …], each with its normal and its "
                     "weight behind where it has them"))
    return;
  BeaconList list;
  const auto& items = at.node().items;
  if (items.empty()) reader.error(at, "the list is empty; give at least one beacon");
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Place place(at, std::to_string(i), items[i]);
    if (!reader.expect(place, Node::Kind::list, "a list of numbers")) continue;
    const std::size_t n = items[i].items.size();
    if (n != 3 && n != 6 && n != 7) {
      reader.error(
          place,
          "expected [x, y, z], or with a normal [x, y, z, nx, ny, nz], or with "
          "a weight behind it, not " +
              std::to_string(n) + " members");
      continue;
    }
    std::vector<double> row;
    for (std::size_t c = 0; c < n; ++c) {
      const auto value = reader.number(Place(place, kRow.columns[c], items[i].items[c]),
                                       c < 3 ? "m" : "1");
      if (value) row.push_back(*value);
    }
    if (row.size() < n) continue;
    const std::string problem = row_problem(row);
    if (problem.empty())
      list.entries.push_back(entry_of(row));
    else
      reader.error(place, problem);
  }
  out.set.layout = std::move(list);
}

void read_file(Reader& reader, const Place& at, BeaconSetDraft& out) {
  const auto written = reader.word(at);
  if (!written) return;
  BeaconList list{reader.file_name(at, *written), {}};
  const auto rows = read_row_file(reader, at, list.file, kRow, "beacons");
  if (!rows) return;
  for (std::size_t i = 0; i < rows->size(); ++i) {
    const std::string problem = row_problem((*rows)[i]);
    if (problem.empty())
      list.entries.push_back(entry_of((*rows)[i]));
    else
      reader.error(at, list.file + ": beacon " + std::to_string(i) + ": " + problem);
  }
  out.set.layout = std::move(list);
}

void read_panel(Reader& reader, const Place& at, BeaconSetDraft& out) {
  if (!reader.expect(at, Node::Kind::list, "two whole numbers [nx, ny]")) return;
  const auto& items = at.node().items;
  if (items.size() != 2)
    return reader.error(at, "expected two whole numbers [nx, ny], not " +
                                std::to_string(items.size()) + " members");
  Eigen::Vector2i panel = {1, 1};
  for (std::size_t i = 0; i < 2; ++i)
    if (const auto n = reader.integer(Place(at, kAxes[i], items[i]), 1,
                                      std::numeric_limits<int>::max()))
      panel[static_cast<Eigen::Index>(i)] = *n;
  out.panel = panel;
}

void read_normal(Reader& reader, const Place& at, BeaconSetDraft& out) {
  const auto normal = reader.vector3(at, "1");
  if (!normal) return;
  if (normal->isZero(0))
    reader.error(at, "has length zero; leave it out where beacons radiate all around");
  out.set.normal = *normal;
}

Node row_node(const BeaconEntry& entry) {
  std::vector<Node> row;
  for (const double x : entry.p) row.push_back(to_node(x));
  if (entry.normal)
    for (const double x : *entry.normal) row.push_back(to_node(x));
  if (entry.normal && entry.weight != 1) row.push_back(to_node(entry.weight));
  return to_node(std::move(row));
}

constexpr Bounds kConeHalfAngle = {.least = 0,
                                   .greatest = std::numbers::pi,
                                   .above = true,
                                   .why = ": the half-angle of the cone"};

constexpr std::array<Key<BeaconSetDraft>, 9> kBeaconKeys = {{
    {"grid", Need::optional, "a regular grid: min, max and step, metres",
     map(volume_keys), read_grid,
     [](const BeaconSetDraft& d) -> Written {
       const auto* grid = std::get_if<BeaconGrid>(&d.set.layout);
       if (!grid) return std::nullopt;
       return write_volume(grid->box);
     }},
    {"list", Need::optional,
     "beacons [x, y, z], [x, y, z, nx, ny, nz] or [x, y, z, nx, ny, nz, weight]",
     list([] { return numbers("1", 3, 7); }, 1), read_list,
     [](const BeaconSetDraft& d) -> Written {
       const auto* list = std::get_if<BeaconList>(&d.set.layout);
       if (!list || !list->file.empty()) return std::nullopt;
       std::vector<Node> rows;
       for (const BeaconEntry& entry : list->entries) rows.push_back(row_node(entry));
       return to_node(std::move(rows));
     }},
    {"file", Need::optional, "such rows in a .csv or .ptl file, relative to the scene",
     text(), read_file,
     [](const BeaconSetDraft& d) -> Written {
       const auto* list = std::get_if<BeaconList>(&d.set.layout);
       if (!list || list->file.empty()) return std::nullopt;
       return to_node(list->file);
     }},
    {"pattern", Need::optional,
     "panels of the grid that are lit: full, half, columns or checkerboard",
     choice<kBeaconPatternWords>(),
     [](Reader& r, const Place& p, BeaconSetDraft& d) {
       d.pattern = r.choice(p, kBeaconPatternWords);
     },
     [](const BeaconSetDraft& d) -> Written {
       if (!d.pattern) return std::nullopt;
       return to_node(word_of(kBeaconPatternWords, *d.pattern));
     }},
    {"panel", Need::optional, "beacons of a panel along x and y, [nx, ny]",
     numbers("1", 2, 2, at_least(1)), read_panel,
     [](const BeaconSetDraft& d) -> Written {
       if (!d.panel) return std::nullopt;
       return to_node(std::vector<Node>{to_node(d.panel->x()), to_node(d.panel->y())});
     }},
    {"normal", Need::optional, "which way they face, [x, y, z]", vector("1"),
     read_normal,
     [](const BeaconSetDraft& d) -> Written {
       if (!d.set.normal) return std::nullopt;
       return vector_node(*d.set.normal);
     }},
    {"emission", Need::optional, "half-angle of their cone of light about the normal",
     number("rad", kConeHalfAngle),
     [](Reader& r, const Place& p, BeaconSetDraft& d) {
       if (const auto v = r.number(p)) d.set.emission = *v;
     },
     [](const BeaconSetDraft& d) -> Written {
       if (d.set.emission == BeaconSet{}.emission) return std::nullopt;
       return to_node(d.set.emission);
     }},
    {"range", Need::optional, "farthest that they are seen, metres",
     number("m", above(0)),
     [](Reader& r, const Place& p, BeaconSetDraft& d) {
       if (const auto v = r.number(p)) d.set.range = *v;
     },
     [](const BeaconSetDraft& d) -> Written {
       if (d.set.range == BeaconSet{}.range) return std::nullopt;
       return to_node(d.set.range);
     }},
    {"weight", Need::optional, "the part of the time that each can be used, 0 to 1",
     number("1", between(0, 1)),
     [](Reader& r, const Place& p, BeaconSetDraft& d) {
       if (const auto v = r.number(p)) d.set.weight = *v;
     },
     [](const BeaconSetDraft& d) -> Written {
       if (d.set.weight == BeaconSet{}.weight) return std::nullopt;
       return to_node(d.set.weight);
     }},
}};

/// Exactly one key says where the beacons are; pattern and panel are of a grid.
void check_layout(Reader& reader, const Place& at, const BeaconSetDraft& draft) {
  std::string given;
  for (const char* key : {"grid", "list", "file"}) {
    const Node* node = at.node().find(key);
    if (!node) continue;
    if (!given.empty())
      reader.error_within(at, node->mark, key,
                          "the beacons are given by '" + given + "' already; keep one");
    given = key;
  }
  if (given.empty()) reader.error(at, "no beacons; give grid, list or file");
  for (const char* key : {"pattern", "panel"})
    if (const Node* node = at.node().find(key);
        node && !given.empty() && given != "grid")
      reader.error_within(at, node->mark, key,
                          "is of a grid; leave out the rows that are off");
  if (const Node* node = at.node().find("emission");
      node && !draft.set.normal && given == "grid")
    reader.error_within(at, node->mark, "emission",
                        "is about the normal; give 'normal' too");
}

}  // namespace

Shape beacon_set_shape() { return map<kBeaconKeys>(); }

void read_beacons(Reader& reader, const Place& at, std::vector<BeaconSet>& out) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of names to sets of beacons"))
    return;
  const Node& node = at.node();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Place place(at, node.keys[i].text, node.items[i]);
    BeaconSetDraft draft;
    draft.set.name = reader.key_name(at, i);
    if (!read_map(reader, place, kBeaconKeys, draft)) continue;
    check_layout(reader, place, draft);
    if (auto* grid = std::get_if<BeaconGrid>(&draft.set.layout)) {
      grid->pattern = draft.pattern.value_or(grid->pattern);
      grid->panel = draft.panel.value_or(grid->panel);
    }
    out.push_back(std::move(draft.set));
  }
}

Node write_beacons(const std::vector<BeaconSet>& beacons) {
  Node map;
  map.kind = Node::Kind::map;
  for (const BeaconSet& set : beacons) {
    BeaconSetDraft draft{set, std::nullopt, std::nullopt};
    if (const auto* grid = std::get_if<BeaconGrid>(&set.layout)) {
      draft.pattern = grid->pattern;
      if (grid->panel != BeaconGrid{}.panel) draft.panel = grid->panel;
    }
    map.keys.push_back({set.name, {}});
    map.items.push_back(write_map(kBeaconKeys, draft));
  }
  return map;
}

}  // namespace delos
