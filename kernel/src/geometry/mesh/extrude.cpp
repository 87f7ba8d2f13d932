// Prisms over polygons, whose caps CGAL triangulates.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "delos/geometry/primitives.h"
#include "geometry/mesh/kernel.h"

namespace delos {
namespace {

using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<
                CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>,
                CGAL::Constrained_triangulation_face_base_2<Kernel>>>;

CGAL::Polygon_2<Kernel> checked(const std::vector<Eigen::Vector2d>& polygon) {
  if (polygon.size() < 3) {
    throw std::invalid_argument("a polygon needs at least three corners, not " +
                                std::to_string(polygon.size()));
  }
  if (polygon.front() == polygon.back()) {
    throw std::invalid_argument(
        "the last corner of the polygon repeats the first; leave it out, polygons are "
        "closed anyway");
  }
  CGAL::Polygon_2<Kernel> checked;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (!polygon[i].allFinite()) {
      throw std::invalid_argument("corner " + std::to_string(i) +
                                  " of the polygon isn't finite");
    }
    checked.push_back({polygon[i].x(), polygon[i].y()});
  }
  if (!checked.is_simple()) {
    throw std::invalid_argument("edges of the polygon touch or cross each other");
  }
  return checked;
}

/// Triangles that fill a simple polygon, counterclockwise; indices of its corners.
std::vector<std::array<std::uint32_t, 3>> filled(
    const CGAL::Polygon_2<Kernel>& polygon) {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> corners;
  for (const auto& p : polygon.vertices()) {
    corners.push_back(triangulation.insert(p));
    corners.back()->info() = static_cast<std::uint32_t>(corners.size() - 1);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    triangulation.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
  }

  // A face is inside where crossing an odd number of the polygon's edges leads to it.
  std::map<Triangulation::Face_handle, bool> inside;
  std::vector<Triangulation::Face_handle> open{triangulation.infinite_face()};
  inside[open.back()] = false;
  while (!open.empty()) {
    const auto face = open.back();
    open.pop_back();
    for (int i = 0; i < 3; ++i) {
      const auto next = face->neighbor(i);
      if (inside.contains(next)) continue;
      inside[next] = inside[face] != face->is_constrained(i);
      open.push_back(next);
    }
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& face : triangulation.finite_face_handles()) {
    if (!inside[face]) continue;
    triangles.push_back(
        {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  return triangles;
}

}  // namespace

TriangleMesh extrude(const std::vector<Eigen::Vector2d>& polygon, double height) {
  const CGAL::Polygon_2<Kernel> outline = checked(polygon);
  const bool counterclockwise = outline.is_counterclockwise_oriented();
  const auto n = static_cast<std::uint32_t>(polygon.size());
  TriangleMesh mesh;
  for (const double z : {0.0, height}) {
    for (const Eigen::Vector2d& p : polygon)
      mesh.vertices.emplace_back(p.x(), p.y(), z);
  }
  for (const auto& [a, b, c] : filled(outline)) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({a + n, b + n, c + n});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    const std::uint32_t from = counterclockwise ? i : j, to = counterclockwise ? j : i;
    mesh.triangles.push_back({from, to, to + n});
    mesh.triangles.push_back({from, to + n, from + n});
  }
  return mesh;
}

}  // namespace delos
