#include "scene/clutter_keys.h"

#include "document/node_text.h"
#include "scene/body_keys.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

/// More would take memory that nobody means to spend.
constexpr int kMostBodies = 10'000;

constexpr std::pair<const char*, ClutterShape> kClutterShapeWords[] = {
    {"box", ClutterShape::box}, {"sphere", ClutterShape::sphere}};

constexpr Bounds kSize = above(0);

void read_size(Reader& reader, const Place& at, ClutterEntry& out) {
  const char* form = "two lengths [least, greatest]";
  if (!reader.expect(at, Node::Kind::list, form)) return;
  const auto& items = at.node().items;
  if (items.size() != 2) {
    reader.error(at, std::string("expected ") + form + ", not " +
                         std::to_string(items.size()) + " members");
    return;
  }
  const Place most(at, "1", items[1]);
  const auto least = reader.number(Place(at, "0", items[0]), "m"),
             greatest = reader.number(most, "m");
  if (!least || !greatest) return;
  reader.within(Place(at, "0", items[0]), *least, kSize, "m");
  if (*greatest < *least) reader.error(most, "is below the least; exchange them");
  out.least = *least;
  out.greatest = *greatest;
}

constexpr std::array<Key<ClutterEntry>, 5> kClutterKeys = {{
    member_key<&ClutterEntry::count>(
        "count", Need::required, "how many bodies are drawn", integer(0, kMostBodies)),
    member_key<&ClutterEntry::seed>(
        "seed", Need::optional, "of the random numbers: another one, another clutter",
        integer(0)),
    {"shape", Need::optional, "box or sphere", choice<kClutterShapeWords>(),
     [](Reader& r, const Place& p, ClutterEntry& c) {
       if (const auto shape = r.choice(p, kClutterShapeWords)) c.shape = *shape;
     },
     [](const ClutterEntry& c) -> Written {
       return to_node(std::string(word_of(kClutterShapeWords, c.shape)));
     }},
    {"size", Need::required, "edges of boxes, or diameters, [least, greatest], metres",
     numbers("m", 2, 2, kSize), read_size,
     [](const ClutterEntry& c) -> Written {
       return to_node(std::vector<Node>{to_node(c.least), to_node(c.greatest)});
     }},
    {"box", Need::required, "where their centres are: its corners min and max",
     map(box_keys),
     [](Reader& r, const Place& p, ClutterEntry& c) {
       if (const auto box = read_box(r, p)) c.box = *box;
     },
     [](const ClutterEntry& c) -> Written { return write_box(c.box); }},
}};

}  // namespace

Shape clutter_shape() { return map<kClutterKeys>(); }

void read_clutter(Reader& reader, const Place& at, std::vector<ClutterEntry>& out) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of names to what is drawn"))
    return;
  const Node& node = at.node();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    ClutterEntry entry;
    entry.name = reader.key_name(at, i);
    if (read_map(reader, Place(at, node.keys[i].text, node.items[i]), kClutterKeys,
                 entry))
      out.push_back(std::move(entry));
  }
}

Node write_clutter(const std::vector<ClutterEntry>& clutter) {
  Node map;
  map.kind = Node::Kind::map;
  for (const ClutterEntry& entry : clutter) {
    map.keys.push_back({entry.name, {}});
    map.items.push_back(write_map(kClutterKeys, entry));
  }
  return map;
}

}  // namespace delos
