// Triangle meshes, and the files that they come from.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "delos/api.h"
#include "delos/model/pose.h"

namespace delos {

/// Triangles over shared vertices. Seen from outside, corners run counterclockwise, so
/// that (b − a) × (c − a) points outward.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;                ///< metres, in one frame
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of vertices
};

/// Read a mesh. The suffix, in either case, tells the format: .off, .obj, .ply and
/// .stl, the last two as text or binary, and .glb or .gltf, whose y axis is up and
/// becomes z. Coordinates are taken as they stand: the caller knows the file's unit
/// (see transformed()). Polygons are fanned into triangles from their first corner;
/// what isn't a surface (colours, normals, textures) is left out. Corners of glTF in
/// one place are one vertex.
///
/// @param progress called now and then with the part of the file read so far, in [0, 1]
/// @returns at least one triangle; all vertices finite, all indices in range
/// @throws std::runtime_error with one sentence that starts with the file: it is
/// missing,
///         its suffix is unknown, it can't be understood or announces more than it
///         holds, a vertex isn't finite, a face names a vertex that doesn't exist, or
///         it has no triangle
/// @cost linear in the file (binary STL: n log n, as equal corners are merged)
[[nodiscard]] DELOS_API TriangleMesh
read_mesh(const std::filesystem::path& file,
          const std::function<void(double fraction)>& progress = {});

/// The mesh scaled about its frame's origin, then placed: p_A = X_AB · (scale · p_B).
/// @pre scale > 0
[[nodiscard]] DELOS_API TriangleMesh transformed(TriangleMesh mesh, const Pose& X_AB,
                                                 double scale = 1);

/// Told now and then how much of a mesh file has been read, in [0, 1].
using MeshProgress =
    std::function<void(const std::filesystem::path& file, double fraction)>;

}  // namespace delos
