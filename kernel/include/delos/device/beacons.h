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
    return reaches(way, way.norm());
  }
  /// The same of the way from it to the point, and how long that is.
  [[nodiscard]] bool reaches(const Eigen::Vector3d& way, double distance) const {
    if (distance > range) return false;
    return normal.isZero(0) || normal.dot(way) >= cos_emission * distance;
  }
};

/// Beacons sorted by place, so that a query costs about what it finds: neighbours stand
/// side by side, with balls around every eight of them, around every eight balls, and
/// so on.
class DELOS_API BeaconIndex {
 public:
  explicit BeaconIndex(std::vector<Beacon> beacons);

  [[nodiscard]] std::size_t size() const { return beacons_.size(); }
  /// Beacon i in the order of the index, where neighbours in space are near.
  [[nodiscard]] const Beacon& operator[](std::size_t i) const { return beacons_[i]; }
  /// Its place in the list that the index was made of.
  [[nodiscard]] std::size_t listed(std::size_t i) const { return listed_[i]; }

  /// Append all that lie in a cone of W, its edge included, in the order of the index.
  /// @cost about that of the beacons found; of a cone of a right angle or more, of all
  void find(const ViewCone& cone, std::vector<std::uint32_t>& found) const;
  /// Append all that lie in a cone of W or within so many metres of it, and so what the
  /// cone holds wherever its apex moves by no more; maybe others beside it, too.
  /// @cost as of find()
  void find_near(const ViewCone& cone, double metres,
                 std::vector<std::uint32_t>& found) const;

  /// How large the balls around eight neighbours are in the mean: their radius, metres.
  [[nodiscard]] double patch() const { return patch_; }

  /// How many balls lie in a larger one.
  static constexpr std::uint32_t kFan = 8;

  /// As many balls side by side, in W, metres; a radius below 0: there is none.
  struct Balls {
    float x[kFan], y[kFan], z[kFan], radius[kFan];
  };

 private:
  void sort(std::size_t first, std::size_t last, std::size_t size,
            const std::vector<Beacon>& beacons);
  void stack();

  std::vector<Beacon> beacons_;
  std::vector<std::uint32_t> listed_;
  /// The beacons themselves, the balls around eight each, …, one group of balls.
  std::vector<std::vector<Balls>> levels_;
  double extent_ = 0;  // greatest coordinate, metres
  double patch_ = 0;
};

}  // namespace delos
