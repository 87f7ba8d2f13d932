#include "scene/surface_keys.h"

#include <algorithm>

#include "delos/text/numbers.h"
#include "document/node_text.h"
#include "scene/mesh_keys.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

constexpr std::array<Key<PatchSurface>, 3> kPatchKeys = {{
    member_key<&PatchSurface::origin>("origin", Need::required,
                                      "corner [x, y, z], metres", vector("m")),
    member_key<&PatchSurface::u>("u", Need::required, "first edge [x, y, z], metres",
                                 vector("m")),
    member_key<&PatchSurface::v>("v", Need::required, "second edge [x, y, z], metres",
                                 vector("m")),
}};

PatchSurface read_patch(Reader& reader, const Place& at) {
  const std::size_t before = reader.findings.errors();
  PatchSurface patch;
  read_map(reader, at, kPatchKeys, patch);
  if (reader.findings.errors() == before &&
      !(patch.u.cross(patch.v).norm() > 1e-9 * patch.u.norm() * patch.v.norm()))
    reader.error(at, "u and v don't span a surface: they are parallel, or one is zero");
  return patch;
}

/// A surface while it is read: `scale` and `from` stand beside `mesh`.
struct SurfaceDraft {
  SurfaceEntry surface;
  MeshSurface hull;
};

void read_rail(Reader& reader, const Place& at, SurfaceDraft& out) {
  auto points = reader.vectors3(at, "m");
  if (!points) return;
  if (std::all_of(points->begin(), points->end(),
                  [&](const Eigen::Vector3d& p) { return p == points->front(); }))
    reader.error(at, "has no length; give two points or more");
  out.surface.shape = RailSurface{std::move(*points)};
}

template <class Shape>
const Shape* shape_of(const SurfaceDraft& draft) {
  return std::get_if<Shape>(&draft.surface.shape);
}

constexpr std::array<Key<SurfaceDraft>, 5> kSurfaceKeys = {{
    {"patch", Need::optional, "parallelogram that faces along u × v: origin, u, v",
     map<kPatchKeys>(),
     [](Reader& r, const Place& p, SurfaceDraft& d) {
       d.surface.shape = read_patch(r, p);
     },
     [](const SurfaceDraft& d) -> Written {
       const auto* patch = shape_of<PatchSurface>(d);
       if (!patch) return std::nullopt;
       return write_map(kPatchKeys, *patch);
     }},
    {"rail", Need::optional, "line through points [[x, y, z], …], metres", points(),
     read_rail,
     [](const SurfaceDraft& d) -> Written {
       const auto* rail = shape_of<RailSurface>(d);
       if (!rail) return std::nullopt;
       return to_node(rail->points);
     }},
    {"mesh", Need::optional,
     "a .off, .obj, .ply, .stl, .glb or .gltf file, relative to the scene", text(),
     [](Reader& r, const Place& p, SurfaceDraft& d) {
       read_mesh_file(r, p, d.hull.mesh);
     },
     [](const SurfaceDraft& d) -> Written {
       const auto* hull = shape_of<MeshSurface>(d);
       if (!hull) return std::nullopt;
       return to_node(hull->mesh.file);
     }},
    {"scale", Need::optional, "metres per unit of the mesh's file", kScaleShape,
     [](Reader& r, const Place& p, SurfaceDraft& d) { read_scale(r, p, d.hull.mesh); },
     [](const SurfaceDraft& d) -> Written {
       const auto* hull = shape_of<MeshSurface>(d);
       if (!hull) return std::nullopt;
       return write_scale(hull->mesh);
     }},
    {"from", Need::optional, "patch whose points are thrown on the mesh along u × v",
     map<kPatchKeys>(),
     [](Reader& r, const Place& p, SurfaceDraft& d) { d.hull.from = read_patch(r, p); },
     [](const SurfaceDraft& d) -> Written {
       const auto* hull = shape_of<MeshSurface>(d);
       if (!hull) return std::nullopt;
       return write_map(kPatchKeys, hull->from);
     }},
}};

/// Exactly one shape; `from` and `scale` with a mesh only.
void check_surface(Reader& reader, const Place& at, SurfaceDraft& draft,
                   std::size_t before) {
  std::string given;
  for (const char* shape : {"patch", "rail", "mesh"}) {
    const Node* node = at.node().find(shape);
    if (!node) continue;
    if (!given.empty())
      reader.error_within(at, node->mark, shape,
                          "the surface is given by '" + given + "' already; keep one");
    given = shape;
  }
  if (given.empty()) reader.error(at, "there is no surface; give patch, rail or mesh");
  for (const char* key : {"scale", "from"}) {
    const Node* node = at.node().find(key);
    if (node && !at.node().find("mesh"))
      reader.error_within(at, node->mark, key, "belongs to a mesh; leave it out");
  }
  if (given == "mesh" && !at.node().find("from"))
    reader.error_within(at, at.node().mark, "from",
                        "missing: patch whose points are thrown on the mesh");
  if (given != "mesh" || reader.findings.errors() != before) return;
  check_mesh_size(reader, Place(at, "mesh", *at.node().find("mesh")), draft.hull.mesh);
  draft.surface.shape = draft.hull;
}

std::size_t coordinate_count(const SurfaceEntry& surface) {
  return std::holds_alternative<RailSurface>(surface.shape) ? 1 : 2;
}

}  // namespace

Shape surface_shape() { return map<kSurfaceKeys>(); }

void read_surfaces(Reader& reader, const Place& at, std::vector<SurfaceEntry>& out) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of names to surfaces")) return;
  const Node& node = at.node();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Place place(at, node.keys[i].text, node.items[i]);
    const std::size_t before = reader.findings.errors();
    SurfaceDraft draft;
    draft.surface.name = reader.key_name(at, i);
    if (!read_map(reader, place, kSurfaceKeys, draft)) continue;
    check_surface(reader, place, draft, before);
    out.push_back(std::move(draft.surface));
  }
}

Node write_surfaces(const std::vector<SurfaceEntry>& surfaces) {
  Node map;
  map.kind = Node::Kind::map;
  for (const SurfaceEntry& surface : surfaces) {
    map.keys.push_back({surface.name, {}});
    map.items.push_back(write_map(kSurfaceKeys, SurfaceDraft{surface, {}}));
  }
  return map;
}

void read_on(Reader& reader, const Place& at, DeviceEntry& out) {
  auto surface = reader.word(at);
  if (!surface) return;
  if (!out.mounting) out.mounting.emplace();
  out.mounting->surface = std::move(*surface);
}

void read_coordinates(Reader& reader, const Place& at, DeviceEntry& out) {
  if (!out.mounting) out.mounting.emplace();
  std::vector<double>& coordinates = out.mounting->coordinates;
  const auto read_one = [&](const Place& place) {
    const auto value = reader.number(place, "1");
    if (!value) return;
    if (*value < 0 || *value > 1)
      reader.error(place, place.node().text + " is outside 0 to 1, the surface's ends");
    coordinates.push_back(*value);
  };
  if (at.node().kind == Node::Kind::scalar) return read_one(at);
  if (!reader.expect(at, Node::Kind::list, "a list of numbers from 0 to 1")) return;
  for (std::size_t i = 0; i < at.node().items.size(); ++i)
    read_one(Place(at, std::to_string(i), at.node().items[i]));
}

std::optional<Node> write_on(const DeviceEntry& device) {
  if (!device.mounting) return std::nullopt;
  return to_node(device.mounting->surface);
}

std::optional<Node> write_coordinates(const DeviceEntry& device) {
  if (!device.mounting) return std::nullopt;
  std::vector<Node> numbers;
  for (const double c : device.mounting->coordinates) numbers.push_back(to_node(c));
  return to_node(std::move(numbers));
}

std::optional<MountPoint> check_mounting(Reader& reader, const Place& at,
                                         const DeviceEntry& device,
                                         const std::vector<SurfaceEntry>* surfaces) {
  const Node* on = at.node().find("on");
  const Node* coordinates = at.node().find("coordinates");
  if (!on && !coordinates) return std::nullopt;
  const std::size_t before = reader.findings.errors();
  if (!on) {
    reader.error_within(at, coordinates->mark, "coordinates",
                        "belong to a surface; give 'on' too, or 'at' instead");
    return std::nullopt;
  }
  if (!coordinates)
    reader.error_within(at, on->mark, "coordinates",
                        "missing: where on the surface, numbers from 0 to 1");
  if (const Node* node = at.node().find("at"))
    reader.error_within(at, node->mark, "at",
                        "the place is given by 'on' already; keep one");
  if (const Node* node = at.node().find("group"))
    reader.error_within(at, node->mark, "group",
                        "surfaces are in the world; leave out 'group' or 'on'");
  if (!surfaces || on->kind != Node::Kind::scalar) return std::nullopt;

  const std::string& name = device.mounting->surface;
  const auto surface =
      std::find_if(surfaces->begin(), surfaces->end(),
                   [&](const SurfaceEntry& s) { return s.name == name; });
  if (surface == surfaces->end()) {
    std::vector<std::string> known;
    for (const SurfaceEntry& s : *surfaces) known.push_back(s.name);
    reader.error_within(
        at, on->mark, "on",
        "there is no surface '" + name + '\'' +
            (known.empty() ? "; the scene declares none" : suggestion(name, known)));
    return std::nullopt;
  }
  if (reader.findings.errors() != before || !coordinates) return std::nullopt;
  const std::size_t wanted = coordinate_count(*surface);
  const std::size_t given = device.mounting->coordinates.size();
  if (given != wanted) {
    reader.error_within(at, coordinates->mark, "coordinates",
                        wanted == 1
                            ? '\'' + name + "' is a rail: expected one number, not " +
                                  std::to_string(given)
                            : '\'' + name +
                                  "' has two coordinates, along u and v: "
                                  "expected two numbers, not " +
                                  std::to_string(given));
    return std::nullopt;
  }
  const auto point = mount_point(*surface, device.mounting->coordinates);
  if (!point)
    reader.error_within(
        at, coordinates->mark, "coordinates",
        "the ray from here along u × v hits nothing of '" + name +
            "'; move the patch 'from', or turn it by exchanging u and v");
  return point;
}

}  // namespace delos
