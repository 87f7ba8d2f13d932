// What views about a device's z axis have in common: a cone as their edge, and how
// depth goes on beyond it.
#pragma once

#include <cmath>
#include <type_traits>

#include "delos/device/reading.h"

namespace delos {

/// All directions up to a half-angle from the z axis.
class AxisCone {
 public:
  /// @param half_angle radians, 0 to π
  explicit AxisCone(double half_angle)
      : sine_(std::sin(half_angle)), cosine_(std::cos(half_angle)) {}

  /// How far inside the cone a point is, metres, at least 0 inside:
  ///
  ///   sin α z − cos α ρ,   ρ = √(x² + y²)
  ///
  /// and where it is more than a right angle off the edge, ± its distance.
  template <class T>
  [[nodiscard]] T inside(const Point<T>& p) const {
    using std::sqrt;
    const T rho = aside(p), margin = sine_ * p.z - cosine_ * rho;
    const T distance = sqrt(squared_norm(p));
    const bool near_apex = cosine_ * plain(p.z) + sine_ * plain(rho) < 0;
    return chosen(near_apex, chosen(plain(margin) < 0, T(-distance), distance), margin);
  }

  /// ρ, which has slopes on the axis, too.
  template <class T>
  [[nodiscard]] static T aside(const Point<T>& p) {
    using std::sqrt;
    return sqrt(p.x * p.x + p.y * p.y + 1e-24 * squared_norm(p));
  }

 private:
  double sine_, cosine_;
};

/// The depth of a point, above 0 wherever it is: z where z ≥ c d, with d the distance,
/// and beyond, which searches alone ask about,
///
///   c d (1 + exp(2 (z/(c d) − 1)))/2
///
/// @param least c, below the cosine of the angle to the z axis of all that is seen
template <class T>
[[nodiscard]] T soft_depth(const Point<T>& p, double least) {
  if constexpr (!std::is_same_v<T, SecondOrder>) {
    return p.z;
  } else {
    const T floor = least * sqrt(squared_norm(p));
    if (!(plain(p.z) < plain(floor))) return p.z;
    return floor * (1.0 + exp(2.0 * (p.z / floor - 1.0))) / 2.0;
  }
}

}  // namespace delos
