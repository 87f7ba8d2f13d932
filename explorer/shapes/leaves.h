// The cells of an octree as lines.
#pragma once

#include <optional>
#include <vector>

#include "shapes/sheet.h"

namespace delos::shapes {

struct LeafEdges {
  std::vector<Eigen::Vector3d> ends;  ///< two a line, each line once; metres
  std::size_t leaves = 0;             ///< that they are the edges of
};

/// The twelve edges of each leaf, those that leaves share once. Where a leaf's edge
/// lies on a part of a larger one's, both are there.
/// @param points of the field's samples, of which `part` is the octree
/// @param near the leaves that a plane meets, by default all; those that only touch it
///        with their upper side don't, but at the end of the box
[[nodiscard]] LeafEdges leaf_edges(const std::vector<Eigen::Vector3d>& points,
                                   const SamplePart& part, const OctreeShape& octree,
                                   const std::optional<AxisPlane>& near = {});

}  // namespace delos::shapes
