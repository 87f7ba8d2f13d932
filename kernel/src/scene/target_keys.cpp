#include "scene/target_keys.h"

#include <numbers>

#include "document/node_text.h"
#include "scene/placement_keys.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

/// Half-angle of a cone about a normal.
constexpr Shape kHalfAngle =
    number("rad", {.least = 0,
                   .greatest = std::numbers::pi,
                   .above = true,
                   .why = ": the half-angle of the cone from where it is seen"});

constexpr std::array<Key<MarkerEntry>, 3> kMarkerKeys = {{
    member_key<&MarkerEntry::at>("at", Need::required,
                                 "its place in the body's frame, [x, y, z], metres",
                                 vector("m")),
    {"normal", Need::optional, "which way it faces, [x, y, z], in the body's frame",
     vector("1"),
     [](Reader& r, const Place& p, MarkerEntry& m) {
       const auto v = r.vector3(p, "1");
       if (!v) return;
       if (v->isZero(0))
         r.error(p, "has length zero; leave it out where it is seen from all around");
       m.normal = *v;
     },
     [](const MarkerEntry& m) -> Written {
       if (!m.normal) return std::nullopt;
       return vector_node(*m.normal);
     }},
    other_key<&MarkerEntry::half_angle>(
        "half_angle", Need::optional,
        "of the cone about its normal from where it is seen; default: the body's",
        kHalfAngle),
}};

void read_marker(Reader& reader, const Place& at, MarkerEntry& out) {
  if (at.node().kind == Node::Kind::list) {
    if (const auto v = reader.vector3(at, "m")) out.at = *v;
    return;
  }
  if (!read_map(reader, at, kMarkerKeys, out)) return;
  const Node* angle = at.node().find("half_angle");
  if (angle && !at.node().find("normal"))
    reader.error_within(at, angle->mark, "half_angle",
                        "is about a normal; say which way the marker faces");
}

void read_body_markers(Reader& reader, const Place& at, MarkerBody& out) {
  if (!reader.expect(at, Node::Kind::list,
                     "a list of markers, [x, y, z] or {at, normal, half_angle}"))
    return;
  const auto& items = at.node().items;
  if (items.empty()) reader.error(at, "the list is empty; give at least one marker");
  for (std::size_t i = 0; i < items.size(); ++i)
    read_marker(reader, Place(at, std::to_string(i), items[i]),
                out.markers.emplace_back());
}

Shape marker_shape() {
  return either([] { return std::vector{vector("m"), map<kMarkerKeys>()}; });
}

constexpr std::array<Key<MarkerBody>, 2> kMarkerBodyOwnKeys = {{
    {"markers", Need::required,
     "its markers: [x, y, z] in its frame, metres, seen from all around, or {at, "
     "normal, half_angle}",
     list(marker_shape, 1), read_body_markers,
     [](const MarkerBody& b) -> Written {
       std::vector<Node> list;
       for (const MarkerEntry& marker : b.markers)
         list.push_back(marker.normal ? write_map(kMarkerKeys, marker)
                                      : vector_node(marker.at));
       return to_node(std::move(list));
     }},
    member_key<&MarkerBody::half_angle>(
        "half_angle", Need::optional,
        "of the cone about each normal from where the marker is seen", kHalfAngle),
}};
constexpr auto kMarkerBodyKeys = concat(kMarkerBodyOwnKeys, kPlacementKeys<MarkerBody>);

void read_bodies(Reader& reader, const Place& at, Scene& scene) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of names to bodies of markers"))
    return;
  const Node& node = at.node();
  if (node.items.empty()) reader.error(at, "is empty; name a body, or leave it out");
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Place place(at, node.keys[i].text, node.items[i]);
    MarkerBody& body = scene.bodies.emplace_back();
    body.name = reader.key_name(at, i);
    if (read_map(reader, place, kMarkerBodyKeys, body))
      check_placement(reader, place, body.placement);
  }
}

constexpr std::array<Key<Scene>, 3> kTargetKeys = {{
    {"markers", Need::optional,
     "points on the target [[x, y, z], …], metres, in its frame", points(),
     [](Reader& r, const Place& p, Scene& s) {
       if (auto markers = r.vectors3(p, "m")) s.markers = std::move(*markers);
     },
     [](const Scene& s) -> Written {
       if (s.markers.empty()) return std::nullopt;
       return to_node(s.markers);
     }},
    {"bodies", Need::optional, "named bodies of markers that face somewhere",
     table([] { return map<kMarkerBodyKeys>(); }), read_bodies,
     [](const Scene& s) -> Written {
       if (s.bodies.empty()) return std::nullopt;
       Node map;
       map.kind = Node::Kind::map;
       for (const MarkerBody& body : s.bodies) {
         map.keys.push_back({body.name, {}});
         map.items.push_back(write_map(kMarkerBodyKeys, body));
       }
       return map;
     }},
    other_key<&Scene::speed>(
        "speed", Need::optional,
        "how fast it is, in any direction, root mean square: what delays count with",
        number("m/s", at_least(0))),
}};

}  // namespace

std::vector<KeyShape> target_keys() { return keys_of<kTargetKeys>(); }

void read_target(Reader& reader, const Place& at, Scene& scene) {
  if (!read_map(reader, at, kTargetKeys, scene)) return;
  // The marker that is there where nothing else is said.
  if (at.node().find("bodies") && !at.node().find("markers")) scene.markers.clear();
}

std::optional<Node> write_target(const Scene& scene) {
  if (scene.markers == Scene{}.markers && scene.bodies.empty() && scene.speed == 0)
    return std::nullopt;
  return write_map(kTargetKeys, scene);
}

}  // namespace delos
