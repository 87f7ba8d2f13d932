#include "shapes/leaves.h"

#include <algorithm>
#include <cstdint>

namespace delos::shapes {
namespace {

/// Whether a leaf from `low` to `high` is met; `end` is the box's.
bool meets(double at, double low, double high, double end) {
  return low <= at && (at < high || (at <= high && high == end));
}

/// A plane, and the box that it is in. @pre the part has points
struct Plane {
  int axis;
  double at, end;
};

Plane plane_in(const std::vector<Eigen::Vector3d>& points, const SamplePart& part,
               const AxisPlane& near) {
  double low = points[part.first][near.axis], high = low;
  for (std::size_t i = 0; i < part.count; ++i) {
    low = std::min(low, points[part.first + i][near.axis]);
    high = std::max(high, points[part.first + i][near.axis]);
  }
  return {near.axis, near.at.value_or((low + high) / 2), high};
}

}  // namespace

LeafEdges leaf_edges(const std::vector<Eigen::Vector3d>& points, const SamplePart& part,
                     const OctreeShape& octree, const std::optional<AxisPlane>& near) {
  std::optional<Plane> plane;
  if (near) plane = plane_in(points, part, *near);
  LeafEdges edges;
  std::vector<std::uint64_t> lines;
  for (const auto& cell : octree.cells) {
    if (plane && !meets(plane->at, points[part.first + cell[0]][plane->axis],
                        points[part.first + cell[7]][plane->axis], plane->end))
      continue;
    ++edges.leaves;
    for (std::size_t from = 0; from < 8; ++from)
      for (const std::size_t step : {1u, 2u, 4u})
        if ((from & step) == 0) {
          const auto [a, b] = std::minmax(cell[from], cell[from + step]);
          lines.push_back(std::uint64_t{a} << 32 | b);
        }
  }
  std::ranges::sort(lines);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  for (const std::uint64_t line : lines)
    for (const std::uint64_t node : {line >> 32, line & 0xffffffff})
      edges.ends.push_back(points[part.first + node]);
  return edges;
}

}  // namespace delos::shapes
