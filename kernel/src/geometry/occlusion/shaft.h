// The convex hull of a point and a box, and what certainly misses it.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <span>

namespace delos {

/// The hull is bounded by the axis-aligned box around the point, called the apex, and
/// the box, and by the planes through the apex and those edges of the box where a face
/// that the apex sees meets one that it doesn't. The tests say "may meet" with a margin
/// for the rounding of coordinates, so that "no" is certain.
class Shaft {
 public:
  /// A plane through the apex and an edge along one of the axes: it cuts the other two.
  struct Plane {
    int i, j;         // the axes that it cuts
    double n_i, n_j;  // its outward normal
    double slack;  // n·(x − apex) is beyond doubt above this, x in the hull's bounds
  };

  Shaft(const Eigen::Vector3d& apex, const Eigen::AlignedBox3d& box);

  /// A box around the hull, with the margin.
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }

  /// Whether a triangle may meet the hull.
  bool may_meet(const std::array<Eigen::Vector3d, 3>& t) const;

  std::span<const Plane> planes() const {
    return {planes_.data(), static_cast<std::size_t>(plane_count_)};
  }
  const Eigen::Vector3d& apex() const { return apex_; }

 private:
  void add_silhouette(int i, int j);
  /// The same for a box, grown from min to max.
  bool may_meet(const Eigen::Vector3d& min, const Eigen::Vector3d& max) const;

  Eigen::Vector3d apex_;
  Eigen::AlignedBox3d box_;
  Eigen::AlignedBox3d bounds_;  // of the hull, with the margin
  double margin_;               // metres, above the rounding of any coordinate here
  std::array<Plane, 6> planes_;
  int plane_count_ = 0;
};

}  // namespace delos
