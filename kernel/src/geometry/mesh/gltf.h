// glTF 2.0: meshes of a scene of nodes, in a text or in one file with its numbers.
#pragma once

#include <istream>

#include "geometry/mesh/soup.h"

namespace delos {

/// Read the triangles of all meshes in the file's scene, each where its node puts it;
/// colours, normals, skins and animations are left out. Its y axis is up and Delos's z:
/// (x, y, z) becomes (x, −z, y), in metres, as glTF has them. Corners in one place are
/// one vertex, since glTF parts them where normals differ.
///
/// Numbers must be in the file itself: a .glb, or a .gltf with data URIs.
///
/// Source: Khronos Group, glTF 2.0 Specification (ISO/IEC 12113:2022), §3 and §4.
/// @returns false where it can't be understood, or ends too early
/// @throws MeshProblem it needs what isn't read, or names what it doesn't have
bool read_gltf(std::istream& in, SoupPoints& points, SoupPolygons& polygons);

}  // namespace delos
