// What devices that measure a distance have in common.
#pragma once

#include <cmath>

#include "delos/device/device.h"

namespace delos {

/// Measures how far a point is, whichever way it lies:
///
///   z = ‖p‖ + v,   v ~ N(0, R),   R = constant + growing z²,   ∂z/∂p = pᵀ/‖p‖
///
/// A plugin derives from it and says what its parameters make of the two.
class RangeDevice : public Device {
 public:
  /// @param constant variance of a range to a point nearby, m², ≥ 0
  /// @param growing what is added to it, relative to the square of the range, ≥ 0
  /// @param reach farthest point that is seen, metres
  RangeDevice(double constant, double growing, double reach)
      : constant_(constant), growing_(growing), reach_(reach) {}

  [[nodiscard]] bool observe(const Target& target, Observation& out) const override {
    const double range = target.p_ST.norm();
    // At the device itself the range has no direction, hence no derivative.
    if (range == 0 || range > reach_) return false;
    out.z.setConstant(1, range);
    out.H = target.p_ST.transpose() / range;
    out.R.setConstant(1, 1, variance(range));
    return true;
  }

  [[nodiscard]] bool observe_lanes(const PointLanes& points,
                                   RowLanes& out) const override {
    out.rows = 1;
    for (int l = 0; l < kLanes; ++l) {
      const double x = points.p[0][l], y = points.p[1][l], z = points.p[2][l];
      const double range = std::sqrt(x * x + y * y + z * z);
      out.seen[l] = (range > 0) & (range <= reach_) ? 1 : 0;
      out.H[0][0][l] = x / range;
      out.H[0][1][l] = y / range;
      out.H[0][2][l] = z / range;
      out.variance[0][l] = variance(range);
    }
    return true;
  }

  /// @returns false at the device itself, and where the range is perfect
  [[nodiscard]] bool observe_smoothly(const Eigen::Vector3d& p,
                                      SmoothRows& out) const override {
    const double range = p.norm();
    if (range == 0 || variance(range) == 0) return false;
    const Eigen::Vector3d u = p / range;
    out.rows = 1;
    out.margin = (reach_ - range) / range;
    out.margin_slope = -reach_ / (range * range) * u;
    out.H.row(0) = u.transpose();
    out.variance(0) = variance(range);
    // ∂u/∂p = (1 − u uᵀ)/‖p‖
    const Eigen::Matrix3d turn =
        (Eigen::Matrix3d::Identity() - u * u.transpose()) / range;
    for (int k = 0; k < 3; ++k) out.H_slope[k].row(0) = turn.row(k);
    out.variance_slope.row(0) = 2 * growing_ * p.transpose();
    return true;
  }

  [[nodiscard]] View view_of_ball(const Eigen::Vector3d& center,
                                  double radius) const override {
    const double near = center.norm() - radius, far = center.norm() + radius;
    if (near > reach_) return View::outside;
    return near > 0 && far < reach_ ? View::inside : View::crossing;
  }

 private:
  [[nodiscard]] double variance(double range) const {
    return constant_ + growing_ * range * range;
  }

  double constant_;  // m²
  double growing_;   // dimensionless
  double reach_;     // m
};

}  // namespace delos
