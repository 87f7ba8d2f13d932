// Rigid poses and how scenes write them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "delos/api.h"

namespace delos {

/// X_AB: takes coordinates in frame B to coordinates in frame A, p_A = R·p_B + p.
struct Pose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< R_AB, a rotation
  Eigen::Vector3d p = Eigen::Vector3d::Zero();      ///< p_AB, metres

  /// X_AC = X_AB · X_BC.
  friend Pose operator*(const Pose& X_AB, const Pose& X_BC) {
    return {X_AB.R * X_BC.R, X_AB.R * X_BC.p + X_AB.p};
  }
  /// p_A of a point given as p_B.
  friend Eigen::Vector3d operator*(const Pose& X_AB, const Eigen::Vector3d& p_B) {
    return X_AB.R * p_B + X_AB.p;
  }
  /// X_BA.
  [[nodiscard]] Pose inverse() const { return {R.transpose(), -(R.transpose() * p)}; }

  friend bool operator==(const Pose&, const Pose&) = default;
};

/// How a number J that depends on a field changes when a device moves.
/// ∂J/∂[p, φ]: of its place in the world, 1/metres, and of a small turn exp(φ) about
/// the world's axes, 1/radians.
using PoseSlope = Eigen::Matrix<double, 6, 1>;

/// R = Rz(yaw)·Ry(pitch)·Rx(roll) of rpy = (roll, pitch, yaw) in radians.
[[nodiscard]] DELOS_API Eigen::Matrix3d rotation_from_rpy(const Eigen::Vector3d& rpy);

/// Orientation of a sensor at `from` whose z axis looks at `to`: x right, y down, with
/// the frame's z axis as up. Straight up or down, where right is undefined, x stays
/// along the frame's x axis.
/// @pre from ≠ to, both in the same frame, metres.
[[nodiscard]] DELOS_API Eigen::Matrix3d rotation_from_aim(const Eigen::Vector3d& from,
                                                          const Eigen::Vector3d& to);

}  // namespace delos
