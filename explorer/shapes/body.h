// Where a field on a grid lies between two values, and where it has one.
#pragma once

#include <atomic>

#include "delos/sampling/samples.h"
#include "shapes/shape_mesh.h"

namespace delos::shapes {

/// Values at the nodes of a grid.
struct ScalarGrid {
  GridShape grid;
  std::vector<double> value;  ///< x fastest; not finite where there is none
};

/// The surface at a level of what is linear in each of the six tetrahedra of a cell
/// around its diagonal: exact for a linear field, and of second order in the step
/// for others. Closed but at the ends of the grid, and at cells of which a corner has
/// no value. The larger values lie outside.
///
/// Source: Doi & Koide, An efficient method of triangulating equi-valued surfaces by
///         using tetrahedral cells, IEICE Transactions E74 (1991), 214-224.
///
/// @param stop set by others: what comes is of no use any more
[[nodiscard]] ShapeMesh isosurface(const ScalarGrid& grid, double level,
                                   const std::atomic<bool>* stop = nullptr);

/// What bounds the body on which low ≤ value ≤ high, of the same tetrahedra: the
/// surfaces at both, and caps where the grid ends and where a cell has a corner without
/// a value, which is no part of the body. Closed: each edge is gone along once in
/// either direction.
/// @param low, high the ends, ±∞ where there is none
[[nodiscard]] ShapeMesh body_between(const ScalarGrid& grid, double low, double high,
                                     const std::atomic<bool>* stop = nullptr);

}  // namespace delos::shapes
