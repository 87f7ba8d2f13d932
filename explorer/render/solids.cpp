#include "render/solids.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "delos/geometry/primitives.h"

namespace delos::render {

TriangleMesh camera_icon(double size) {
  TriangleMesh mesh = make_box(size * Eigen::Vector3d(-0.4, -0.3, -1.05),
                               size * Eigen::Vector3d(0.4, 0.3, -0.15));
  constexpr int kSides = 20;
  const auto tip = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.emplace_back(0, 0, -0.22 * size);
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    mesh.vertices.push_back(
        size * Eigen::Vector3d(0.38 * std::cos(angle), 0.38 * std::sin(angle), 0.33));
    mesh.triangles.push_back({tip, tip + 1 + static_cast<std::uint32_t>(i),
                              tip + 1 + static_cast<std::uint32_t>((i + 1) % kSides)});
  }
  return mesh;
}

std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> sharp_edges(
    const TriangleMesh& mesh) {
  const double flat = std::cos(std::numbers::pi / 6);
  // By places: meshes may have a vertex for each triangle.
  const auto key = [](const Eigen::Vector3d& p) {
    return std::array<double, 3>{p.x(), p.y(), p.z()};
  };
  using Key = std::array<double, 3>;
  std::map<std::pair<Key, Key>, std::vector<Eigen::Vector3d>> normals;
  for (const auto& t : mesh.triangles) {
    const std::array<Eigen::Vector3d, 3> p{mesh.vertices[t[0]], mesh.vertices[t[1]],
                                           mesh.vertices[t[2]]};
    const Eigen::Vector3d n = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      const Key a = key(p[k]), b = key(p[(k + 1) % 3]);
      normals[{std::min(a, b), std::max(a, b)}].push_back(n);
    }
  }
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> edges;
  for (const auto& [ends, around] : normals) {
    const bool smooth = around.size() >= 2 &&
                        std::ranges::all_of(around, [&](const Eigen::Vector3d& n) {
                          return n.dot(around.front()) >= flat;
                        });
    if (!smooth)
      edges.emplace_back(Eigen::Vector3d(ends.first.data()),
                         Eigen::Vector3d(ends.second.data()));
  }
  return edges;
}

std::vector<Eigen::Vector3d> corners_of(const std::vector<Eigen::Vector3d>& outline) {
  const auto n = static_cast<int>(outline.size());
  std::vector<double> radius;
  for (const Eigen::Vector3d& p : outline) radius.push_back(p.head<2>().norm());
  const double least = *std::ranges::min_element(radius);
  const auto farthest = [&](int i) {
    constexpr int kNear = 3;
    const auto at = [&](int k) {
      return radius[static_cast<std::size_t>((k + n) % n)];
    };
    for (int d = 1; d <= kNear; ++d)
      if (at(i - d) > at(i) - 1e-9 || at(i + d) > at(i)) return false;
    return at(i) > 1.02 * least;
  };
  std::vector<Eigen::Vector3d> corners, some;
  for (int i = 0; i < n; ++i) {
    if (farthest(i)) corners.push_back(outline[static_cast<std::size_t>(i)]);
    if (i % std::max(1, n / 6) == 0)
      some.push_back(outline[static_cast<std::size_t>(i)]);
  }
  return corners.size() >= 3 ? corners : some;
}

}  // namespace delos::render
