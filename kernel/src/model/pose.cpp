#include "delos/model/pose.h"

#include <cmath>

namespace delos {

Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy) {
  const double cr = std::cos(rpy.x()), sr = std::sin(rpy.x());
  const double cp = std::cos(rpy.y()), sp = std::sin(rpy.y());
  const double cy = std::cos(rpy.z()), sy = std::sin(rpy.z());
  Eigen::Matrix3d R;
  R << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,   //
      -sp, cp * sr, cp * cr;
  return R;
}

Eigen::Matrix3d rotation_from_aim(const Eigen::Vector3d& from,
                                  const Eigen::Vector3d& to) {
  const Eigen::Vector3d forward = (to - from).stableNormalized();
  // forward × up, whose length is the sine of the angle to the vertical.
  Eigen::Vector3d right(forward.y(), -forward.x(), 0);
  // Below this sine, rounding of the two points decides where right is.
  constexpr double kVertical = 1e-9;
  if (right.norm() < kVertical)
    right = Eigen::Vector3d::UnitX() - forward.x() * forward;
  right.normalize();
  Eigen::Matrix3d R;
  R << right, forward.cross(right), forward;
  return R;
}

}  // namespace delos
