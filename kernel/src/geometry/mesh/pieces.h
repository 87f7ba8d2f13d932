// Convex pieces of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/topology.h"

namespace delos {

/// Which convex piece each triangle belongs to.
struct Pieces {
  std::vector<std::uint32_t> of_triangle;
  std::uint32_t count = 0;
};

/// Connected components that are closed and convex are one piece; every other triangle
/// is one of its own. Exact: a component passes only if it is convex.
Pieces convex_pieces(const TriangleMesh& mesh, const Topology& topology);

}  // namespace delos
