// Where a field on a grid has one value.
#pragma once

#include <functional>
#include <vector>

#include "delos/geometry/mesh.h"
#include "delos/sampling/samples.h"

namespace delos::render {

/// A surface, and which way it looks at each vertex.
struct Isosurface {
  TriangleMesh mesh;                     ///< the larger values lie outside
  std::vector<Eigen::Vector3d> normals;  ///< unit length, towards larger values
};

/// The surface at a level of what is linear in each of the six tetrahedra of a cell
/// around its diagonal: exact for a linear field, and of second order in the step
/// for others. Closed but at the ends of the grid, and at cells of which a corner has
/// no value.
///
/// Source: Doi & Koide, An efficient method of triangulating equi-valued surfaces by
///         using tetrahedral cells, IEICE Transactions E74 (1991), 214-224.
///
/// @param value of a node, x fastest; not finite where it has none
[[nodiscard]] Isosurface isosurface(const GridShape& grid,
                                    const std::function<double(std::size_t)>& value,
                                    double level);

/// The area of all triangles, m².
[[nodiscard]] double area_of(const TriangleMesh& mesh);

}  // namespace delos::render
