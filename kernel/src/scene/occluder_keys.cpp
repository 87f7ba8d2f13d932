#include "scene/occluder_keys.h"

#include <map>

#include "document/node_text.h"
#include "scene/body_keys.h"
#include "scene/mesh_keys.h"
#include "scene/placement_keys.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

constexpr std::array<Key<OccluderEntry>, 1> kNameKey = {{
    other_key<&OccluderEntry::name>("name", Need::optional,
                                    "a word of your own that messages and paths use",
                                    name()),
}};

constexpr std::array<Key<OccluderEntry>, 1> kMountKey = {{
    {"mount", Need::optional, "what it is fixed to: world or target",
     choice<kMountWords>(),
     [](Reader& r, const Place& p, OccluderEntry& o) {
       if (const auto mount = r.choice(p, kMountWords)) o.mount = *mount;
     },
     [](const OccluderEntry& o) -> Written {
       if (o.mount == Mount::world) return std::nullopt;
       return to_node(word_of(kMountWords, o.mount));
     }},
}};

constexpr std::array<Key<OccluderEntry>, 1> kRoomKey = {{
    {"room", Need::optional, "true: its inside is free and its walls hide",
     choice<kTruthWords>(),
     [](Reader& r, const Place& p, OccluderEntry& o) {
       if (const auto room = r.choice(p, kTruthWords)) o.room = *room;
     },
     [](const OccluderEntry& o) -> Written {
       if (!o.room) return std::nullopt;
       return to_node("true");
     }},
}};

constexpr auto kOccluderKeys =
    concat(concat(concat(kNameKey, kBodyKeys<OccluderEntry>), kRoomKey),
           concat(kMountKey, kPlacementKeys<OccluderEntry>));

constexpr auto kRegionKeys =
    concat(kBodyKeys<RegionEntry>, kPlacementKeys<RegionEntry>);

}  // namespace

Shape occluder_shape() { return map<kOccluderKeys>(); }
Shape region_shape() { return map<kRegionKeys>(); }

void read_occluders(Reader& reader, const Place& at, std::vector<OccluderEntry>& out) {
  if (!reader.expect(at, Node::Kind::list, "a list of bodies")) return;
  const auto& items = at.node().items;
  std::map<std::string, int> line_of;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Place place(at, member_name(items[i], i), items[i]);
    const std::size_t before = reader.findings.errors();
    OccluderEntry entry;
    if (!read_map(reader, place, kOccluderKeys, entry)) continue;
    check_placement(reader, place, entry.placement);
    check_body(reader, place, entry.body, before,
               entry.room ? check_mesh_room : check_mesh_hides);
    if (!entry.name.empty()) {
      const Mark mark = items[i].find("name")->mark;
      const auto [first, is_new] = line_of.emplace(entry.name, mark.line);
      if (!is_new)
        reader.error_within(place, mark, "name",
                            '\'' + entry.name + "' names the occluder on line " +
                                std::to_string(first->second) + " already");
    }
    out.push_back(std::move(entry));
  }
}

void read_regions(Reader& reader, const Place& at, std::vector<RegionEntry>& out) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of names to bodies")) return;
  const Node& node = at.node();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Place place(at, node.keys[i].text, node.items[i]);
    const std::size_t before = reader.findings.errors();
    RegionEntry region;
    region.name = reader.key_name(at, i);
    if (!read_map(reader, place, kRegionKeys, region)) continue;
    check_placement(reader, place, region.placement);
    check_body(reader, place, region.body, before, check_mesh_contains);
    out.push_back(std::move(region));
  }
}

Node write_occluders(const std::vector<OccluderEntry>& occluders) {
  std::vector<Node> list;
  for (const OccluderEntry& entry : occluders)
    list.push_back(write_map(kOccluderKeys, entry));
  return to_node(std::move(list));
}

Node write_regions(const std::vector<RegionEntry>& regions) {
  Node map;
  map.kind = Node::Kind::map;
  for (const RegionEntry& region : regions) {
    map.keys.push_back({region.name, {}});
    map.items.push_back(write_map(kRegionKeys, region));
  }
  return map;
}

}  // namespace delos
