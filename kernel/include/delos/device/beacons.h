// Beacons in the world, and which of them lie in a cone.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "delos/api.h"
#include "delos/device/device.h"

namespace delos {

/// Something in the world that a device on the target looks at.
struct Beacon {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();       ///< metres, in W
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, in W; zero: no way
  double cos_emission =
      0;  ///< cosine of the half-angle about the normal; read with one
  double range = std::numeric_limits<double>::infinity();  ///< farthest seen, metres
  double weight = 1;  ///< the part of the time that it can be used, 0 to 1

  /// Whether it shines towards a point in W.
  [[nodiscard]] bool reaches(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d way = point - p;
    const double distance = way.norm();
    if (distance > range) return false;
    return normal.isZero(0) || normal.dot(way) >= cos_emission * distance;
  }
};

/// Beacons sorted by place, so that a query costs about what it finds: a binary tree of
/// bounding balls over runs of one array.
class DELOS_API BeaconIndex {
 public:
  explicit BeaconIndex(std::vector<Beacon> beacons);

  [[nodiscard]] std::size_t size() const { return beacons_.size(); }
  /// Beacon i in the order of the index, where neighbours in space are near.
  [[nodiscard]] const Beacon& operator[](std::size_t i) const { return beacons_[i]; }
  /// Its place in the list that the index was made of.
  [[nodiscard]] std::size_t listed(std::size_t i) const { return listed_[i]; }

  /// Append all that lie in a cone of W, its edge included, in the order of the index.
  void find(const ViewCone& cone, std::vector<std::uint32_t>& found) const;

 private:
  /// A ball around beacons [first, last), and the node after its subtree.
  struct Node {
    Eigen::Vector3d center;
    double radius;
    std::uint32_t first, last, next;
  };
  void build(std::uint32_t first, std::uint32_t last,
             const std::vector<Beacon>& beacons);

  std::vector<Beacon> beacons_;
  std::vector<double> p_[3];  // their places again, side by side
  std::vector<std::uint32_t> listed_;
  std::vector<Node> nodes_;
};

}  // namespace delos
