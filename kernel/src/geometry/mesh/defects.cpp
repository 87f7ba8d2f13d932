#include "delos/geometry/defects.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>

#include "geometry/mesh/kernel.h"
#include "geometry/mesh/topology.h"

namespace delos {
namespace {

using VertexIndices = std::array<std::uint32_t, 3>;

/// Tells which triangles of a mesh meet where they shouldn't.
class SelfIntersections {
 public:
  SelfIntersections(const TriangleMesh& mesh, const Topology& topology)
      : corners_(topology.corners) {
    for (const Eigen::Vector3d& p : mesh.vertices) points_.push_back(cgal_point(p));
  }

  /// Counts the pairs among some triangles.
  /// @returns nullopt where too many would have to be looked at
  std::optional<std::size_t> count(const std::vector<std::uint32_t>& triangles) const {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
    std::vector<Box> boxes;
    boxes.reserve(triangles.size());
    for (const std::uint32_t t : triangles) boxes.emplace_back(triangle(t).bbox(), t);
    const std::size_t most = std::max(kMostPairsOfSmall, kMostPairs * triangles.size());
    struct TooMany {};
    std::size_t looked_at = 0, pairs = 0;
    try {
      CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                    [&](const Box& a, const Box& b) {
                                      if (++looked_at > most) throw TooMany();
                                      pairs += intersect(a.info(), b.info());
                                    });
    } catch (const TooMany&) {
      return std::nullopt;
    }
    return pairs;
  }

 private:
  Kernel::Triangle_3 triangle(std::uint32_t t) const {
    const auto& [a, b, c] = corners_[t];
    return {points_[a], points_[b], points_[c]};
  }

  /// Whether two triangles meet elsewhere than in their common corners and edges.
  bool intersect(std::uint32_t s, std::uint32_t t) const {
    // Common corners first.
    VertexIndices a = corners_[s], b = corners_[t];
    int common = 0;
    for (int i = 0; i < 3; ++i) {
      const auto same = std::find(b.begin() + common, b.end(), a[i]);
      if (same == b.end()) continue;
      std::iter_swap(same, b.begin() + common);
      std::swap(a[i], a[common]);
      ++common;
    }
    switch (common) {
      case 0:
        return CGAL::do_intersect(triangle(s), triangle(t));
      case 1:
        // What they share is convex: if more than the corner, then it reaches the edge
        // opposite the corner in one of them.
        return CGAL::do_intersect(triangle(s), opposite(b)) ||
               CGAL::do_intersect(triangle(t), opposite(a));
      case 2:
        // They overlap if they are folded flat onto each other.
        return CGAL::coplanar(points_[a[0]], points_[a[1]], points_[a[2]],
                              points_[b[2]]) &&
               CGAL::coplanar_orientation(points_[a[0]], points_[a[1]], points_[a[2]],
                                          points_[b[2]]) == CGAL::POSITIVE;
      default:
        return false;
    }
  }

  Kernel::Segment_3 opposite(const VertexIndices& c) const {
    return {points_[c[1]], points_[c[2]]};
  }

  const std::vector<VertexIndices>& corners_;
  std::vector<Kernel::Point_3> points_;
};

/// Six times the volume that a closed surface bounds, m³, about a point near it.
double signed_volume(const TriangleMesh& mesh, const Topology& topology) {
  const Eigen::Vector3d origin = mesh.vertices.front();
  double volume = 0;
  for (std::size_t t = 0; t < topology.corners.size(); ++t) {
    if (topology.skipped[t]) continue;
    const auto& [a, b, c] = topology.corners[t];
    volume += (mesh.vertices[a] - origin)
                  .dot((mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin));
  }
  return volume;
}

}  // namespace

MeshDefects find_defects(const TriangleMesh& mesh) {
  const Topology topology = topology_of(mesh);
  MeshDefects defects;
  defects.duplicate = topology.duplicates;

  std::vector<std::uint32_t> with_area;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = topology.corners[t];
    if (CGAL::collinear(cgal_point(mesh.vertices[a]), cgal_point(mesh.vertices[b]),
                        cgal_point(mesh.vertices[c]))) {
      ++defects.degenerate;
    } else if (!topology.skipped[t]) {
      with_area.push_back(t);
    }
  }

  for_each_edge(topology, [&](std::uint32_t, std::span<const HalfEdge> edge) {
    defects.border_edges += edge.size() == 1;
    defects.non_manifold_edges += edge.size() > 2;
    defects.flipped_edges += edge.size() == 2 && edge[0].rising == edge[1].rising;
  });
  const Closure closure = closure_of(topology);
  defects.closed = closure.closed;
  defects.inverted =
      closure.closed && closure.oriented && signed_volume(mesh, topology) < 0;

  if (mesh.triangles.size() <= kSelfIntersectionLimit) {
    defects.self_intersections = SelfIntersections(mesh, topology).count(with_area);
  }
  return defects;
}

}  // namespace delos
