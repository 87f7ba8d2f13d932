#include "delos/geometry/primitives.h"

#include <cmath>
#include <map>
#include <numbers>

namespace delos {

TriangleMesh make_box(const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  TriangleMesh mesh;
  // Corner i is at max along x, y, z where bits 0, 1, 2 of i are set.
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back(i & 1 ? max.x() : min.x(), i & 2 ? max.y() : min.y(),
                               i & 4 ? max.z() : min.z());
  }
  mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5},   // x
                    {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},   // y
                    {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};  // z
  return mesh;
}

TriangleMesh make_cylinder(double radius, double height, int sides) {
  std::vector<Eigen::Vector2d> circle;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    circle.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return extrude(circle, height);
}

TriangleMesh make_sphere(double radius, int subdivisions) {
  TriangleMesh mesh;
  // An icosahedron's corners are those of three golden rectangles at right angles.
  const double g = std::numbers::phi;
  mesh.vertices = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                   {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                   {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (Eigen::Vector3d& p : mesh.vertices) p.normalize();
  for (int k = 0; k < subdivisions; ++k) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] = middles.try_emplace(
          std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
      if (is_new) {
        mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
      }
      return at->second;
    };
    std::vector<std::array<std::uint32_t, 3>> quarters;
    quarters.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      quarters.insert(quarters.end(),
                      {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(quarters);
  }
  for (Eigen::Vector3d& p : mesh.vertices) p *= radius;
  return mesh;
}

}  // namespace delos
