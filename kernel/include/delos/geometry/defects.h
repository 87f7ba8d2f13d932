// What is wrong with a mesh, counted.
#pragma once

#include <cstddef>
#include <optional>

#include "delos/api.h"
#include "delos/geometry/mesh.h"

namespace delos {

/// Largest mesh whose triangles are compared with each other.
inline constexpr std::size_t kSelfIntersectionLimit = 1'000'000;
/// Most pairs of triangles with boxes that meet, for one triangle of a mesh on average,
/// and for a small mesh: fans of polygons with thousands of corners have more.
inline constexpr std::size_t kMostPairs = 30, kMostPairsOfSmall = 1'000'000;

/// Defects of a mesh. Vertices at equal positions count as one, however often the file
/// lists them. None of these stops a mesh from hiding things: an open one hides but has
/// no inside.
struct MeshDefects {
  std::size_t degenerate = 0;          ///< triangles without area, which hide nothing
  std::size_t duplicate = 0;           ///< triangles with the corners of an earlier one
  std::size_t border_edges = 0;        ///< edges of one triangle only
  std::size_t non_manifold_edges = 0;  ///< edges of more than two triangles
  /// Edges whose triangles don't face the same way.
  std::size_t flipped_edges = 0;
  /// Pairs of triangles that meet elsewhere than in their common corners and edges,
  /// duplicates left out; nullopt above these limits, where nobody has looked.
  std::optional<std::size_t> self_intersections;
  /// Whether it has an inside: every edge belongs to an even number of triangles.
  bool closed = false;
  /// Closed, of one orientation, and that faces inward. It still has an inside.
  bool inverted = false;
};

/// @pre vertices finite, indices in range, as read_mesh() returns them
/// @cost n log n, and a few seconds more where very many triangles' boxes overlap
[[nodiscard]] DELOS_API MeshDefects find_defects(const TriangleMesh& mesh);

}  // namespace delos
