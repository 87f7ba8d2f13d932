#include "render/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace delos::render {
namespace {

/// Corners of a cell: bits 0, 1, 2 are steps along x, y, z. Of each tetrahedron they go
/// from the first to the last corner along one axis after another, so that those of
/// neighbouring cells meet in whole triangles.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra{{{0, 1, 3, 7},
                                                         {0, 1, 5, 7},
                                                         {0, 2, 3, 7},
                                                         {0, 2, 6, 7},
                                                         {0, 4, 5, 7},
                                                         {0, 4, 6, 7}}};

struct Node {
  std::size_t index;
  Eigen::Vector3d at;
  double value;
};

class Surface {
 public:
  explicit Surface(double level) : level_(level) {}

  void cut(const std::array<Node, 4>& corners) {
    std::array<const Node*, 4> below{}, above{};
    std::size_t b = 0, a = 0;
    for (const Node& node : corners)
      node.value < level_ ? below[b++] = &node : above[a++] = &node;
    if (b == 0 || a == 0) return;
    const Eigen::Vector3d up = above[0]->at - below[0]->at;
    if (b == 1)
      triangle(vertex(*below[0], *above[0]), vertex(*below[0], *above[1]),
               vertex(*below[0], *above[2]), up);
    else if (a == 1)
      triangle(vertex(*below[0], *above[0]), vertex(*below[1], *above[0]),
               vertex(*below[2], *above[0]), up);
    else {
      const std::array<std::uint32_t, 4> q{
          vertex(*below[0], *above[0]), vertex(*below[0], *above[1]),
          vertex(*below[1], *above[1]), vertex(*below[1], *above[0])};
      triangle(q[0], q[1], q[2], up);
      triangle(q[0], q[2], q[3], up);
    }
  }

  Isosurface taken() {
    out_.normals.assign(out_.mesh.vertices.size(), Eigen::Vector3d::Zero());
    for (const auto& [a, b, c] : out_.mesh.triangles) {
      const Eigen::Vector3d n = normal(a, b, c);
      for (const std::uint32_t corner : {a, b, c}) out_.normals[corner] += n;
    }
    for (Eigen::Vector3d& n : out_.normals) n.normalize();
    return std::move(out_);
  }

 private:
  [[nodiscard]] Eigen::Vector3d normal(std::uint32_t a, std::uint32_t b,
                                       std::uint32_t c) const {
    const auto& v = out_.mesh.vertices;
    return (v[b] - v[a]).cross(v[c] - v[a]);
  }

  /// @param up from below the level to above it, across the triangle
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                const Eigen::Vector3d& up) {
    if (normal(a, b, c).dot(up) < 0) std::swap(b, c);
    out_.mesh.triangles.push_back({a, b, c});
  }

  /// Where an edge crosses the level, one vertex for all tetrahedra around it.
  std::uint32_t vertex(const Node& below, const Node& above) {
    const auto [entry, fresh] = known_.try_emplace(
        {std::min(below.index, above.index), std::max(below.index, above.index)},
        static_cast<std::uint32_t>(out_.mesh.vertices.size()));
    if (fresh) {
      const double t = (level_ - below.value) / (above.value - below.value);
      out_.mesh.vertices.push_back(below.at + t * (above.at - below.at));
    }
    return entry->second;
  }

  struct Hash {
    std::size_t operator()(const std::pair<std::size_t, std::size_t>& key) const {
      return key.first * 0x9e3779b97f4a7c15ull + key.second;
    }
  };

  double level_;
  Isosurface out_;
  std::unordered_map<std::pair<std::size_t, std::size_t>, std::uint32_t, Hash> known_;
};

}  // namespace

Isosurface isosurface(const GridShape& grid,
                      const std::function<double(std::size_t)>& value, double level) {
  Surface surface(level);
  const auto nx = static_cast<std::size_t>(grid.counts.x()),
             ny = static_cast<std::size_t>(grid.counts.y()),
             nz = static_cast<std::size_t>(grid.counts.z());
  for (std::size_t z = 0; z + 1 < nz; ++z)
    for (std::size_t y = 0; y + 1 < ny; ++y)
      for (std::size_t x = 0; x + 1 < nx; ++x) {
        std::array<Node, 8> cell;
        bool whole = true;
        for (std::size_t c = 0; c < 8; ++c) {
          const std::size_t i = x + (c & 1), j = y + (c >> 1 & 1), k = z + (c >> 2);
          Node& node = cell[c];
          node.index = i + nx * (j + ny * k);
          node.at = grid.origin + Eigen::Vector3d(static_cast<double>(i),
                                                  static_cast<double>(j),
                                                  static_cast<double>(k))
                                      .cwiseProduct(grid.step);
          node.value = value(node.index);
          whole = whole && std::isfinite(node.value);
        }
        if (!whole) continue;
        for (const auto& t : kTetrahedra)
          surface.cut({cell[t[0]], cell[t[1]], cell[t[2]], cell[t[3]]});
      }
  return surface.taken();
}

double area_of(const TriangleMesh& mesh) {
  double twice = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    twice += (mesh.vertices[b] - mesh.vertices[a])
                 .cross(mesh.vertices[c] - mesh.vertices[a])
                 .norm();
  return twice / 2;
}

}  // namespace delos::render
