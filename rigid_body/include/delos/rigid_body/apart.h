// Rotation and translation filtered apart: what the joint filter is compared with.
#pragma once

#include <Eigen/Core>

#include "delos/rigid_body/filter.h"

namespace delos::rigid_body {

/// What it is told.
struct ApartNoise {
  /// Added to the variances of ω, v and a at every frame.
  double omega = 1e-5, v = 1e-4, a = 1e-7;
  double turn = 1e-6;   ///< variance of a pose about an axis, rad²
  double place = 1e-6;  ///< and along one, m²
};

/// Two linear filters of the same state (ω, v, a), Eq. 7 of Dorfmüller-Ulhaas (2003):
/// of the turn from one frame's pose to the next, log(R′ Rᵀ) = ω Δt, and of the
/// origin's way, t′ − t = v Δt + a Δt²/2. The origin moves on a parabola, however the
/// body turns; in the joint filter it turns with it.
class ApartFilter {
 public:
  explicit ApartFilter(const ApartNoise& noise = {}) : noise_(noise) {}

  /// Take in the pose of the next frame. @param dt since the frame before, > 0
  void frame(double dt, const BodyPose& before, const BodyPose& after);
  /// As BodyFilter has them; the acceleration is that of the origin.
  void gyroscope(const Eigen::Vector3d& omega, double variance);
  void accelerometer(const Eigen::Vector3d& acceleration, double variance);

  /// Where a pose is a time after the last frame. @param dt that frame's length
  [[nodiscard]] BodyPose moved(double dt, double lag, const BodyPose& pose) const;
  [[nodiscard]] const BodyState& state() const { return state_; }

 private:
  void move_origin(const Eigen::RowVector2d& h, const Eigen::Vector3d& left,
                   double variance);

  ApartNoise noise_;
  BodyState state_;
  bool begun_ = false;
  double turning_ = 1;                                    // variance of each axis of ω
  Eigen::Matrix2d moving_ = Eigen::Matrix2d::Identity();  // of v and a along each axis
};

}  // namespace delos::rigid_body
