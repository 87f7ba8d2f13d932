// What devices that measure a distance have in common.
#pragma once

#include "delos/device/point_device.h"

namespace delos {

/// Measures how far a point is, whichever way it lies:
///
///   z = ‖p‖ + v,   v ~ N(0, R),   R = constant + growing z²
///
/// A plugin derives from it and says what its parameters make of the two.
class RangeDevice : public PointDevice<RangeDevice, 1> {
 public:
  /// @param constant variance of a range to a point nearby, m², ≥ 0
  /// @param growing what is added to it, relative to the square of the range, ≥ 0
  /// @param reach farthest point that is seen, metres
  RangeDevice(double constant, double growing, double reach)
      : constant_(constant), growing_(growing), reach_(reach) {}

  template <class T>
  void read(const Point<T>& p, Reading<T, 1>& out) const {
    using std::sqrt;
    out.z[0] = sqrt(squared_norm(p));
    out.variance[0] = constant_ + growing_ * out.z[0] * out.z[0];
    out.inside = reach_ - out.z[0];
  }

 private:
  double constant_;  // m²
  double growing_;   // dimensionless
  double reach_;     // m
};

}  // namespace delos
