// Meshes in files: what the keys `mesh` and `scale` say.
#pragma once

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

/// Read the file's name, and the file. `out.mesh` stays null where there is a finding.
void read_mesh_file(Reader& reader, const Place& at, MeshShape& out);

/// Metres per unit of the file.
void read_scale(Reader& reader, const Place& at, MeshShape& out);

/// What the scale alone decides: whether the mesh is of a size that can be meant.
/// @param at the file's name
void check_mesh_size(Reader& reader, const Place& at, const MeshShape& shape);

/// Warn of defects, once a file.
/// @param at the file's name
void check_mesh_hides(Reader& reader, const Place& at, const MeshShape& shape);

/// The same of a room, whose faces look inward as a rule.
void check_mesh_room(Reader& reader, const Place& at, const MeshShape& shape);

/// The same for a mesh that is of no use without an inside: an open one is an error.
void check_mesh_contains(Reader& reader, const Place& at, const MeshShape& shape);

/// Of the key that tells it.
inline constexpr Shape kScaleShape =
    shapes::number("1", above(0, ": it is metres per unit of the file"));

/// nullopt where it is 1.
[[nodiscard]] std::optional<Node> write_scale(const MeshShape& shape);

}  // namespace delos
