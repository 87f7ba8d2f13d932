// Whether a point is in a cone.
#pragma once

#include <cmath>
#include <numbers>

#include "delos/device/device.h"

namespace delos {

/// A point at depth a along a cone's axis and d from its apex is in it where
/// a ≥ d cos θ, and so, without a root, where a|a| ≥ d² cos θ |cos θ|.
class ConeTest {
 public:
  explicit ConeTest(const ViewCone& cone)
      : square_range_(cone.range * cone.range),
        edge_(cone.half_angle >= std::numbers::pi
                  ? -2  // all around
                  : std::cos(cone.half_angle) * std::abs(std::cos(cone.half_angle))) {}

  /// @param a depth along the axis, metres
  /// @param square d², m²
  [[nodiscard]] bool holds(double a, double square) const {
    return (a * std::abs(a) >= edge_ * square) & (square <= square_range_);
  }

 private:
  double square_range_, edge_;
};

}  // namespace delos
