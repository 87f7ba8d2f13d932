// Points for statistics over a volume, more of them where the field has edges.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "delos/sampling/octree.h"

namespace delos {

/// Points in pairs 2k, 2k + 1: drawn independently, each evenly, from one of the boxes
/// that the volume is cut into.
struct VolumePoints {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> weight;  ///< one a point: half of its box, m³
};

/// Boxes of about equal volume, an eighth of that in cells that an edge may cross.
/// @param edge  asked of cells: false means that no edge crosses it
/// @param about how many points, within a factor of two or so
[[nodiscard]] VolumePoints volume_points(const Octree& tree,
                                         const std::function<bool(Octree::Index)>& edge,
                                         int about, std::uint64_t seed);

}  // namespace delos
