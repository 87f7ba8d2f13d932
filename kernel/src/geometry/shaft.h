// The convex hull of a point and a box, as seen by a tree of boxes and triangles.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

namespace delos {

/// The hull is bounded by the axis-aligned box around the point, called the apex, and
/// the box, and by the planes through the apex and those edges of the box where a face
/// that the apex sees meets one that it doesn't. The tests say "may meet" with a margin
/// for the rounding of coordinates, so that "no" is certain.
class Shaft {
 public:
  Shaft(const Eigen::Vector3d& apex, const Eigen::AlignedBox3d& box);

  /// Whether a box, grown from min to max, may meet the hull.
  bool may_meet(const Eigen::Vector3d& min, const Eigen::Vector3d& max) const;

  /// Whether a triangle may meet the hull.
  bool may_meet(const std::array<Eigen::Vector3d, 3>& corners) const;

 private:
  void add_silhouette(int i, int j);

  Eigen::Vector3d apex_;
  Eigen::AlignedBox3d box_;
  Eigen::AlignedBox3d bounds_;  // of the hull, with the margin
  double margin_;               // metres, above the rounding of any coordinate here
  std::array<Eigen::Vector3d, 6> normals_;  // outward, of the planes through the apex
  int planes_ = 0;
};

}  // namespace delos
