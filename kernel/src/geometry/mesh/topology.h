// How a mesh hangs together, whichever way its file lists the vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "delos/geometry/mesh.h"

namespace delos {

/// One side of an edge: what a triangle has of it. The edge's other vertex is the one
/// that the half edge is filed under.
struct HalfEdge {
  std::uint32_t high;      ///< the edge's greater vertex
  std::uint32_t triangle;  ///< whose edge it is
  bool rising;             ///< whether the triangle runs from the smaller vertex to it
};

/// A mesh whose vertices at equal positions are one.
struct Topology {
  /// Corners of each triangle after merging; indices of the mesh's vertices.
  std::vector<std::array<std::uint32_t, 3>> corners;
  /// Whether a triangle is left out below: it has a corner twice, or the corners of an
  /// earlier triangle.
  std::vector<char> skipped;
  std::size_t duplicates = 0;  ///< triangles with the corners of an earlier one

  /// The half edges whose smaller vertex is v are [first[v], first[v + 1]), by `high`.
  std::vector<std::uint32_t> first;
  std::vector<HalfEdge> half_edges;
};

/// @cost linear
Topology topology_of(const TriangleMesh& mesh);

/// Calls f(low, half edges) for each edge, in order of its vertices; low is the
/// smaller.
template <class Function>
void for_each_edge(const Topology& topology, Function f) {
  for (std::uint32_t v = 0; v + 1 < topology.first.size(); ++v) {
    std::uint32_t begin = topology.first[v];
    while (begin < topology.first[v + 1]) {
      std::uint32_t end = begin + 1;
      while (end < topology.first[v + 1] &&
             topology.half_edges[end].high == topology.half_edges[begin].high) {
        ++end;
      }
      f(v, std::span(topology.half_edges).subspan(begin, end - begin));
      begin = end;
    }
  }
}

/// What the edges say about having an inside.
struct Closure {
  bool closed = true;  ///< every edge has an even number of triangles, and there is one
  bool oriented = true;  ///< every edge is run as often one way as the other
};

Closure closure_of(const Topology& topology);

}  // namespace delos
