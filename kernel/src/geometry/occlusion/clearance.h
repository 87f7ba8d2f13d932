// How far sight lines pass from what hides: the soft edge of shadows.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "delos/api.h"
#include "delos/geometry/mesh.h"

namespace delos {

/// How far a segment passes from the nearest triangle.
struct Passage {
  double distance = 0;  ///< metres
  double part = 0;      ///< where the segment is nearest: 0 at a, 1 at b
  /// Unit, from the triangle to the segment there; ∂distance/∂a = (1 − part) away,
  /// ∂distance/∂b = part away. Zero where they meet.
  Eigen::Vector3d away = Eigen::Vector3d::Zero();
};

/// The triangles of several meshes in one frame, for distances from segments. Immutable
/// and safe to ask from many threads at once. In plain doubles: unlike Occluders, it
/// doesn't decide what hides.
class DELOS_API Clearance {
 public:
  explicit Clearance(const std::vector<TriangleMesh>& parts);

  /// The nearest passage of a→b; one of distance `limit` where no triangle is nearer.
  [[nodiscard]] Passage passage(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                double limit) const;

  [[nodiscard]] bool empty() const { return triangles_.empty(); }

 private:
  struct Triangle {
    std::array<Eigen::Vector3d, 3> corners;
    Eigen::Vector3d normal;  ///< of any length
  };
  struct Node {
    Eigen::Vector3d min, max;
    std::uint32_t first = 0;  ///< of a leaf's triangles, or of its two children
    std::uint32_t count = 0;  ///< of a leaf's triangles; 0: not a leaf
  };
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t count, int depth);

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

}  // namespace delos
