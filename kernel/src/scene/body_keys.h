// Bodies: the keys box, cylinder, sphere, prism, mesh and scale of occluders and
// regions.
#pragma once

#include <optional>

#include "delos/scene/scene.h"
#include "document/keys.h"
#include "scene/mesh_keys.h"

namespace delos {

/// A box with an extent along every axis. nullopt: there is a finding.
[[nodiscard]] std::optional<BoxShape> read_box(Reader& reader, const Place& at);
[[nodiscard]] Node write_box(const BoxShape& box);

// The keys of each body.
[[nodiscard]] std::vector<KeyShape> box_keys();
[[nodiscard]] std::vector<KeyShape> cylinder_keys();
[[nodiscard]] std::vector<KeyShape> sphere_keys();
[[nodiscard]] std::vector<KeyShape> prism_keys();

// Each sets `out` to its own shape; where there is a finding, to one without meaning.
void read_box_body(Reader& reader, const Place& at, Body& out);
void read_cylinder_body(Reader& reader, const Place& at, Body& out);
void read_sphere_body(Reader& reader, const Place& at, Body& out);
void read_prism_body(Reader& reader, const Place& at, Body& out);
void read_mesh_body(Reader& reader, const Place& at, Body& out);
void read_mesh_body_scale(Reader& reader, const Place& at, Body& out);

// nullopt where the body is another one.
[[nodiscard]] std::optional<Node> write_box_body(const Body& body);
[[nodiscard]] std::optional<Node> write_cylinder_body(const Body& body);
[[nodiscard]] std::optional<Node> write_sphere_body(const Body& body);
[[nodiscard]] std::optional<Node> write_prism_body(const Body& body);
[[nodiscard]] std::optional<Node> write_mesh_body(const Body& body);
[[nodiscard]] std::optional<Node> write_mesh_body_scale(const Body& body);

/// What only the keys together tell: there is exactly one body, which can be made of
/// triangles.
/// @param check_mesh what its use asks of a mesh
/// @param before     findings before the body was read
void check_body(Reader& reader, const Place& at, const Body& body, std::size_t before,
                void (*check_mesh)(Reader&, const Place&, const MeshShape&));

// T is anything with a Body called body.
template <class T>
inline constexpr std::array<Key<T>, 6> kBodyKeys = {{
    {"box", Need::optional, "box along the axes: its corners min and max",
     shapes::map(box_keys),
     [](Reader& r, const Place& p, T& t) { read_box_body(r, p, t.body); },
     [](const T& t) { return write_box_body(t.body); }},
    {"cylinder", Need::optional, "cylinder about the z axis: radius, height, sides",
     shapes::map(cylinder_keys),
     [](Reader& r, const Place& p, T& t) { read_cylinder_body(r, p, t.body); },
     [](const T& t) { return write_cylinder_body(t.body); }},
    {"sphere", Need::optional, "sphere about the origin: radius",
     shapes::map(sphere_keys),
     [](Reader& r, const Place& p, T& t) { read_sphere_body(r, p, t.body); },
     [](const T& t) { return write_sphere_body(t.body); }},
    {"prism", Need::optional, "prism over a polygon in the xy plane: polygon, height",
     shapes::map(prism_keys),
     [](Reader& r, const Place& p, T& t) { read_prism_body(r, p, t.body); },
     [](const T& t) { return write_prism_body(t.body); }},
    {"mesh", Need::optional,
     "a .off, .obj, .ply, .stl, .glb or .gltf file, relative to the scene",
     shapes::text(),
     [](Reader& r, const Place& p, T& t) { read_mesh_body(r, p, t.body); },
     [](const T& t) { return write_mesh_body(t.body); }},
    {"scale", Need::optional, "metres per unit of the mesh's file", kScaleShape,
     [](Reader& r, const Place& p, T& t) { read_mesh_body_scale(r, p, t.body); },
     [](const T& t) { return write_mesh_body_scale(t.body); }},
}};

}  // namespace delos
