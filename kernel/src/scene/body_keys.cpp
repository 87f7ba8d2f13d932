#include "scene/body_keys.h"

#include <stdexcept>

#include "document/node_text.h"
#include "scene/mesh_keys.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

/// The greatest number of sides: more would only slow down what looks round already.
constexpr int kMostSides = 1000;

// ---- box ----

constexpr std::array<Key<BoxShape>, 2> kBoxKeys = {{
    member_key<&BoxShape::min>("min", Need::required, "corner [x, y, z], metres",
                               vector("m")),
    member_key<&BoxShape::max>("max", Need::required,
                               "opposite corner [x, y, z], metres", vector("m")),
}};

// ---- cylinder ----

constexpr std::array<Key<CylinderShape>, 3> kCylinderKeys = {{
    member_key<&CylinderShape::radius>("radius", Need::required, "metres",
                                       number("m", above(0))),
    member_key<&CylinderShape::height>("height", Need::required,
                                       "metres, from z = 0 up", number("m", above(0))),
    other_key<&CylinderShape::sides>("sides", Need::optional,
                                     "flat sides that it is made of",
                                     integer(3, kMostSides)),
}};

// ---- sphere ----

constexpr std::array<Key<SphereShape>, 1> kSphereKeys = {{
    member_key<&SphereShape::radius>("radius", Need::required, "metres",
                                     number("m", above(0))),
}};

// ---- prism ----

void read_polygon(Reader& reader, const Place& at, PrismShape& out) {
  if (!reader.expect(at, Node::Kind::list, "a list of corners [[x, y], …]")) return;
  const auto& items = at.node().items;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Place corner(at, std::to_string(i), items[i]);
    if (!reader.expect(corner, Node::Kind::list, "two numbers [x, y]")) continue;
    if (items[i].items.size() != 2) {
      reader.error(corner, "expected two numbers [x, y], not " +
                               std::to_string(items[i].items.size()) + " members");
      continue;
    }
    const auto x = reader.number(Place(corner, kAxes[0], items[i].items[0]), "m");
    const auto y = reader.number(Place(corner, kAxes[1], items[i].items[1]), "m");
    if (x && y) out.polygon.emplace_back(*x, *y);
  }
}

constexpr std::array<Key<PrismShape>, 2> kPrismKeys = {{
    {"polygon", Need::required, "corners in order [[x, y], …], metres",
     list([] { return numbers("m", 2, 2); }), read_polygon,
     [](const PrismShape& s) -> Written {
       std::vector<Node> corners;
       for (const Eigen::Vector2d& corner : s.polygon)
         corners.push_back(vector_node(corner));
       return to_node(std::move(corners));
     }},
    member_key<&PrismShape::height>("height", Need::required, "metres, from z = 0 up",
                                    number("m", above(0))),
}};

/// The shape where the body is one.
template <class Shape, std::size_t N>
Written write_shape(const std::array<Key<Shape>, N>& keys, const Body& body) {
  const auto* shape = std::get_if<Shape>(&body);
  if (!shape) return std::nullopt;
  return write_map(keys, *shape);
}

}  // namespace

std::vector<KeyShape> box_keys() { return keys_of<kBoxKeys>(); }
std::vector<KeyShape> cylinder_keys() { return keys_of<kCylinderKeys>(); }
std::vector<KeyShape> sphere_keys() { return keys_of<kSphereKeys>(); }
std::vector<KeyShape> prism_keys() { return keys_of<kPrismKeys>(); }

std::optional<BoxShape> read_box(Reader& reader, const Place& at) {
  const std::size_t before = reader.findings.errors();
  BoxShape box;
  read_map(reader, at, kBoxKeys, box);
  if (reader.findings.errors() != before) return std::nullopt;
  const Place max(at, "max", *at.node().find("max"));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (box.max[axis] > box.min[axis]) continue;
    const Node& item = max.node().items[i];
    reader.error(Place(max, kAxes[i], item),
                 item.text + " isn't above min; a box extends along every axis");
  }
  if (reader.findings.errors() != before) return std::nullopt;
  return box;
}

Node write_box(const BoxShape& box) { return write_map(kBoxKeys, box); }

void read_box_body(Reader& reader, const Place& at, Body& out) {
  out = read_box(reader, at).value_or(BoxShape{});
}

void read_cylinder_body(Reader& reader, const Place& at, Body& out) {
  read_map(reader, at, kCylinderKeys, out.emplace<CylinderShape>());
}

void read_sphere_body(Reader& reader, const Place& at, Body& out) {
  read_map(reader, at, kSphereKeys, out.emplace<SphereShape>());
}

void read_prism_body(Reader& reader, const Place& at, Body& out) {
  read_map(reader, at, kPrismKeys, out.emplace<PrismShape>());
}

void read_mesh_body(Reader& reader, const Place& at, Body& out) {
  read_mesh_file(reader, at, out.emplace<MeshShape>());
}

void read_mesh_body_scale(Reader& reader, const Place& at, Body& out) {
  if (auto* mesh = std::get_if<MeshShape>(&out))
    read_scale(reader, at, *mesh);
  else
    reader.error(at, "only a mesh has a scale; other bodies are in metres");
}

Written write_box_body(const Body& body) { return write_shape(kBoxKeys, body); }
Written write_cylinder_body(const Body& body) {
  return write_shape(kCylinderKeys, body);
}
Written write_sphere_body(const Body& body) { return write_shape(kSphereKeys, body); }
Written write_prism_body(const Body& body) { return write_shape(kPrismKeys, body); }

Written write_mesh_body(const Body& body) {
  const auto* mesh = std::get_if<MeshShape>(&body);
  if (!mesh) return std::nullopt;
  return to_node(mesh->file);
}

Written write_mesh_body_scale(const Body& body) {
  const auto* mesh = std::get_if<MeshShape>(&body);
  if (!mesh) return std::nullopt;
  return write_scale(*mesh);
}

void check_body(Reader& reader, const Place& at, const Body& body, std::size_t before,
                void (*check_mesh)(Reader&, const Place&, const MeshShape&)) {
  const Node* given = nullptr;
  std::string key;
  for (const char* shape : {"box", "cylinder", "sphere", "prism", "mesh"}) {
    const Node* node = at.node().find(shape);
    if (!node) continue;
    if (given)
      reader.error_within(at, node->mark, shape,
                          "the body is given by '" + key + "' already; keep one");
    given = node;
    key = shape;
  }
  if (!given)
    reader.error(at, "there is no body; give box, cylinder, sphere, prism or mesh");
  if (reader.findings.errors() != before) return;

  const Place place(at, key, *given);
  if (const auto* mesh = std::get_if<MeshShape>(&body)) {
    check_mesh_size(reader, place, *mesh);
    check_mesh(reader, place, *mesh);
    return;
  }
  try {
    static_cast<void>(body_mesh(body));
  } catch (const std::invalid_argument& e) {
    if (const Node* polygon = given->find("polygon"))
      reader.error(Place(place, "polygon", *polygon), e.what());
    else
      reader.error(place, e.what());
  }
}

}  // namespace delos
