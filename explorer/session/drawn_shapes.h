// Surfaces, bodies and lines of a field that is drawn.
#pragma once

#include <variant>

#include "session/drawn_field.h"
#include "shapes/body.h"
#include "shapes/leaves.h"
#include "shapes/relief.h"

namespace delos::session {

/// Where grids have one value, SI.
struct LevelShape {
  double level = 0;
};
/// Where the values of grids lie between two, SI; ±∞: without an end.
struct BetweenShape {
  double low = 0, high = 0;
};
/// A layer of each grid, or all planes, as high as their values.
struct ReliefShape {
  std::optional<shapes::AxisPlane> layer;  ///< none: the planes that are sampled
  shapes::Heights heights;
};
using FieldShape = std::variant<LevelShape, BetweenShape, ReliefShape>;

/// Values of a sample as shapes take them: not a number where none is drawn.
[[nodiscard]] double drawn_value(const DrawnField& drawn, std::size_t sample);

/// Those of a grid.
[[nodiscard]] shapes::ScalarGrid grid_values(const DrawnField& drawn,
                                             const SamplePart& part,
                                             const GridShape& grid);

/// One mesh for each part of the field that can have the shape.
/// @param stop set by others: what comes is of no use any more
[[nodiscard]] std::vector<shapes::ShapeMesh> shapes_of(const DrawnField& drawn,
                                                       const FieldShape& shape,
                                                       const std::atomic<bool>* stop);

/// Edges of the leaves of the octree that a field was read from; none where there is
/// no octree.
/// @param near as shapes::leaf_edges()
[[nodiscard]] shapes::LeafEdges leaves_of(const DrawnField& drawn,
                                          const std::optional<shapes::AxisPlane>& near);

/// Shapes that were made, in the order in which they were asked for.
struct MadeShapes {
  std::vector<std::vector<shapes::ShapeMesh>> meshes;
  std::optional<shapes::LeafEdges> leaves;
};

/// As packed(), but "DLS1":
///
///   {revision, level,
///    meshes: [{shape, vertices, corners, caps, area,
///              positions, normals: at (float32, 3 each), values: at (float32),
///              triangles: at (uint32, 3 each)}]
///    leaves: {count, lines, positions: at (float32, 6 each)}, or null}
///
/// `shape` counts what was asked for; from the corner `caps` on triangles are flat.
/// @param coarse, revision of the field
[[nodiscard]] std::string packed_shapes(const MadeShapes& made, bool coarse,
                                        std::size_t revision);

}  // namespace delos::session
