// PLY, the polygon file format, as text or binary.
#pragma once

#include <istream>
#include <string>

#include "geometry/mesh/soup.h"

namespace delos {

/// What is wrong with a mesh file, where it can be told better than by its place.
struct MeshProblem {
  std::string why;
};

/// Read the vertices' x, y and z and the faces' lists of them; all else is left out.
///
/// CGAL's reader isn't used: it believes what a header says, in an order that it may
/// not have, and how long a list claims to be.
///
/// Source: G. Turk, The PLY Polygon File Format (1994).
/// @returns false where it can't be understood, or ends too early
/// @throws std::length_error it announces more than points.limit vertices, faces,
///         members of a list or members of any other element
/// @throws MeshProblem its vertices have no x, y and z
bool read_ply(std::istream& in, SoupPoints& points, SoupPolygons& polygons);

}  // namespace delos
