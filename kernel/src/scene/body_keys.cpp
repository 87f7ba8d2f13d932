#include "scene/body_keys.h"

#include <stdexcept>

#include "document/node_text.h"
#include "scene/mesh_keys.h"

namespace delos {
namespace {

using Written = std::optional<Node>;

/// The greatest number of sides: more would only slow down what looks round already.
constexpr int kMostSides = 1000;

void read_length(Reader& reader, const Place& at, double& out) {
  const auto length = reader.number(at, "m");
  if (!length) return;
  if (*length > 0)
    out = *length;
  else
    reader.error(at, "must be above 0");
}

// ---- box ----

constexpr std::array<Key<BoxShape>, 2> kBoxKeys = {{
    {"min", Need::required, "corner [x, y, z], metres",
     [](Reader& r, const Place& p, BoxShape& b) { read_vector(r, p, b.min); },
     [](const BoxShape& b) -> Written { return vector_node(b.min); }},
    {"max", Need::required, "opposite corner [x, y, z], metres",
     [](Reader& r, const Place& p, BoxShape& b) { read_vector(r, p, b.max); },
     [](const BoxShape& b) -> Written { return vector_node(b.max); }},
}};

// ---- cylinder ----

constexpr std::array<Key<CylinderShape>, 3> kCylinderKeys = {{
    {"radius", Need::required, "metres",
     [](Reader& r, const Place& p, CylinderShape& c) { read_length(r, p, c.radius); },
     [](const CylinderShape& c) -> Written { return to_node(c.radius); }},
    {"height", Need::required, "metres, from z = 0 up",
     [](Reader& r, const Place& p, CylinderShape& c) { read_length(r, p, c.height); },
     [](const CylinderShape& c) -> Written { return to_node(c.height); }},
    {"sides", Need::optional, "flat sides that it is made of",
     [](Reader& r, const Place& p, CylinderShape& c) {
       if (const auto sides = r.integer(p, 3, kMostSides)) c.sides = *sides;
     },
     [](const CylinderShape& c) -> Written {
       if (c.sides == CylinderShape{}.sides) return std::nullopt;
       return to_node(c.sides);
     }},
}};

// ---- sphere ----

constexpr std::array<Key<SphereShape>, 1> kSphereKeys = {{
    {"radius", Need::required, "metres",
     [](Reader& r, const Place& p, SphereShape& s) { read_length(r, p, s.radius); },
     [](const SphereShape& s) -> Written { return to_node(s.radius); }},
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
    {"polygon", Need::required, "corners in order [[x, y], …], metres", read_polygon,
     [](const PrismShape& s) -> Written {
       std::vector<Node> corners;
       for (const Eigen::Vector2d& corner : s.polygon)
         corners.push_back(vector_node(corner));
       return to_node(std::move(corners));
     }},
    {"height", Need::required, "metres, from z = 0 up",
     [](Reader& r, const Place& p, PrismShape& s) { read_length(r, p, s.height); },
     [](const PrismShape& s) -> Written { return to_node(s.height); }},
}};

/// The shape where the body is one.
template <class Shape, std::size_t N>
Written write_shape(const std::array<Key<Shape>, N>& keys, const Body& body) {
  const auto* shape = std::get_if<Shape>(&body);
  if (!shape) return std::nullopt;
  return write_map(keys, *shape);
}

}  // namespace

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
