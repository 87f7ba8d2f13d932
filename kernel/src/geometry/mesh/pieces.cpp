#include "geometry/mesh/pieces.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/mesh/predicates.h"

namespace delos {
namespace {

/// Sets of triangles that only grow together.
class Components {
 public:
  explicit Components(std::size_t triangles) : parent_(triangles) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t root(std::uint32_t t) {
    while (parent_[t] != t) t = parent_[t] = parent_[parent_[t]];
    return t;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// What is known of the component that a triangle is the root of.
struct Component {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // sum of corners, then their mean
  std::uint32_t triangles = 0;
  int inside = 0;          // the side of its triangles that the centre is on
  double solid_angle = 0;  // that its triangles fill, seen from the centre
  bool convex = true;      // as far as is known
};

/// The solid angle of a triangle seen from p, in [0, 2π].
/// Source: Van Oosterom & Strackee (1983), IEEE Trans. BME-30(2), 125–126, eq. 8.
double solid_angle(const Eigen::Vector3d& p, const Eigen::Vector3d& corner_a,
                   const Eigen::Vector3d& corner_b, const Eigen::Vector3d& corner_c) {
  const Eigen::Vector3d a = (corner_a - p).normalized();
  const Eigen::Vector3d b = (corner_b - p).normalized();
  const Eigen::Vector3d c = (corner_c - p).normalized();
  return 2 *
         std::atan2(std::abs(a.dot(b.cross(c))), 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

/// The corner of a triangle that isn't on the edge.
std::uint32_t opposite(const std::array<std::uint32_t, 3>& corners, std::uint32_t low,
                       std::uint32_t high) {
  for (std::uint32_t corner : corners) {
    if (corner != low && corner != high) return corner;
  }
  return low;
}

/// Finds which components bound a convex body. It is so where
///   1. every edge has two triangles, which run it in opposite ways: a closed surface;
///   2. the centre is strictly on the same side of all triangles, and they fill 4π of
///   its
///      view: every direction meets the surface once, so that it doesn't cross itself;
///   3. across each edge the surface is flat or bends towards the centre.
/// A surface that is embedded and nowhere bends outward bounds a convex body (Tietze
/// and Nakajima, 1928). Only the sum of 2. is rounded, and it is a multiple of 4π.
class Search {
 public:
  Search(const TriangleMesh& mesh, const Topology& topology)
      : vertices_(mesh.vertices),
        topology_(topology),
        sets_(topology.corners.size()),
        components_(topology.corners.size()) {}

  Pieces run() {
    require_closed();
    require_centre_inside();
    require_no_dent();
    require_single_cover();
    return number();
  }

 private:
  Component& component(std::uint32_t t) { return components_[sets_.root(t)]; }

  std::array<Eigen::Vector3d, 3> points(std::uint32_t t) const {
    const auto& [a, b, c] = topology_.corners[t];
    return {vertices_[a], vertices_[b], vertices_[c]};
  }

  template <class Function>
  void for_each_triangle(Function f) {
    for (std::uint32_t t = 0; t < topology_.corners.size(); ++t) {
      if (!topology_.skipped[t]) f(t, component(t));
    }
  }

  void require_closed() {
    for_each_edge(topology_, [&](std::uint32_t, std::span<const HalfEdge> edge) {
      for (const HalfEdge& half : edge) sets_.join(edge[0].triangle, half.triangle);
    });
    for_each_edge(topology_, [&](std::uint32_t, std::span<const HalfEdge> edge) {
      if (edge.size() != 2 || edge[0].rising == edge[1].rising) {
        component(edge[0].triangle).convex = false;
      }
    });
  }

  void require_centre_inside() {
    for_each_triangle([&](std::uint32_t t, Component& c) {
      for (const Eigen::Vector3d& p : points(t)) c.centre += p;
      ++c.triangles;
    });
    for (Component& c : components_) {
      if (c.triangles > 0) c.centre /= 3.0 * c.triangles;
    }
    for_each_triangle([&](std::uint32_t t, Component& c) {
      if (!c.convex) return;
      const auto& [p, q, r] = points(t);
      const int side = orientation(p, q, r, c.centre);
      if (c.inside == 0) c.inside = side;
      if (side == 0 || side != c.inside) c.convex = false;
    });
  }

  void require_no_dent() {
    for_each_edge(topology_, [&](std::uint32_t low, std::span<const HalfEdge> edge) {
      Component& c = component(edge[0].triangle);
      if (!c.convex) return;
      const auto& [p, q, r] = points(edge[0].triangle);
      const auto& neighbour = topology_.corners[edge[1].triangle];
      const Eigen::Vector3d& s = vertices_[opposite(neighbour, low, edge[0].high)];
      if (orientation(p, q, r, s) == -c.inside) c.convex = false;
    });
  }

  void require_single_cover() {
    for_each_triangle([&](std::uint32_t t, Component& c) {
      if (!c.convex) return;
      const auto& [p, q, r] = points(t);
      c.solid_angle += solid_angle(c.centre, p, q, r);
    });
    for (Component& c : components_) {
      if (c.solid_angle > 6 * std::numbers::pi) c.convex = false;
    }
  }

  /// Pieces are numbered by their first triangle.
  Pieces number() {
    Pieces pieces;
    pieces.of_triangle.resize(topology_.corners.size());
    for (std::uint32_t t = 0; t < topology_.corners.size(); ++t) {
      const std::uint32_t root = sets_.root(t);
      const bool joins = root != t && components_[root].convex;
      pieces.of_triangle[t] = joins ? pieces.of_triangle[root] : pieces.count++;
    }
    return pieces;
  }

  const std::vector<Eigen::Vector3d>& vertices_;
  const Topology& topology_;
  Components sets_;
  std::vector<Component> components_;  // at the root of each
};

}  // namespace

Pieces convex_pieces(const TriangleMesh& mesh, const Topology& topology) {
  return Search(mesh, topology).run();
}

}  // namespace delos
