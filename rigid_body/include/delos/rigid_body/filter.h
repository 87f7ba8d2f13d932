// A Kalman filter of a rigid body's motion from three of its points.
#pragma once

#include <Eigen/Core>
#include <array>

namespace delos::rigid_body {

/// Three points of a body in the world, not in one line, metres.
using BodyPoints = std::array<Eigen::Vector3d, 3>;

/// A body's pose: p_W = R p_B + t.
struct BodyPose {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();
};

/// The points that a pose is measured by where a tracker gives poses: R e_i + t.
[[nodiscard]] BodyPoints unit_points(const BodyPose& pose);
/// F3: the same at an arm of `arm` metres, which weighs a pose's rotation against its
/// translation: R arm e_i + t.
[[nodiscard]] BodyPoints virtual_points(const BodyPose& pose, double arm);

/// How a body moves: s = (ω, v, a), of Theorem 1 (rigid_body/motion.h), in any unit of
/// time.
struct BodyState {
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();  ///< radians a unit of time
  Eigen::Vector3d v = Eigen::Vector3d::Zero();      ///< metres a unit of time
  Eigen::Vector3d a = Eigen::Vector3d::Zero();      ///< metres a unit of time, squared
};

/// Where a point is after a time, and where a pose.
[[nodiscard]] Eigen::Vector3d moved(const BodyState& state, double dt,
                                    const Eigen::Vector3d& p);
[[nodiscard]] BodyPose moved(const BodyState& state, double dt, const BodyPose& pose);
[[nodiscard]] BodyPoints moved(const BodyState& state, double dt,
                               const BodyPoints& points);

/// f = W P_i + V v + A a − P'_i of three points before and after, Eq. 13, and
/// ∂f/∂(ω, v, a), Eq. 15.
struct PointResidual {
  Eigen::Matrix<double, 9, 1> f;
  Eigen::Matrix<double, 9, 9> slope;
  Eigen::Matrix3d W;
};
[[nodiscard]] PointResidual point_residual(const BodyState& state, double dt,
                                           const BodyPoints& before,
                                           const BodyPoints& after);

/// What the filter is told.
struct BodyNoise {
  /// Added to the variances of ω, v and a at every frame.
  double omega = 1e-5, v = 1e-4, a = 1e-7;
  double point = 1e-6;  ///< variance of a coordinate of a point, m²
};

/// The extended Kalman filter over s = (ω, v, a), which holds no pose: poses follow
/// from the points. Each frame's points are measured against those of the frame before,
///
///     s⁻ = s with v + aΔt,   f(s) = W P_i + V v + A a − P'_i = 0 but for noise,
///     ∂f/∂x C (∂f/∂x)ᵀ = σ² (W Wᵀ + I) = 2σ² I for each point,
///
/// and readings of one frame are in two residuals, whose correlation is left out as in
/// the paper. Source: Dorfmüller-Ulhaas (2003), §3.2, Eqs. 9–16.
class BodyFilter {
 public:
  using Covariance = Eigen::Matrix<double, 9, 9>;

  explicit BodyFilter(const BodyNoise& noise = {}) : noise_(noise) {}

  /// Take in the points of the next frame.
  /// @param dt since the frame before, > 0
  void frame(double dt, const BodyPoints& before, const BodyPoints& after);

  /// The motion over the frame that was taken in last.
  [[nodiscard]] const BodyState& state() const { return state_; }
  [[nodiscard]] const Covariance& covariance() const { return P_; }
  /// The motion from the last frame on: v + aΔt. What a display that lags shows is
  /// moved(next(dt), lag, pose).
  [[nodiscard]] BodyState next(double dt) const;
  /// The covariance of next(dt).
  [[nodiscard]] Covariance next_covariance(double dt) const;

  /// Go on over a frame that nothing was seen in.
  void coast(double dt);

  /// Take in what a gyroscope reads at the end of the last frame, in W.
  /// @param variance of an axis, (rad / unit of time)²
  void gyroscope(const Eigen::Vector3d& omega, double variance);

  /// Take in the acceleration, without gravity, of the body's point p then, in W:
  ///
  ///     p″ = ω × (ω × p + v + a Δt) + a
  ///
  /// @param dt the last frame's length
  /// @param variance of an axis, (m / unit of time²)²
  void accelerometer(double dt, const Eigen::Vector3d& p,
                     const Eigen::Vector3d& acceleration, double variance);

 private:
  template <int m>
  void update(const Eigen::Matrix<double, m, 1>& f,
              const Eigen::Matrix<double, m, 9>& slope,
              const Eigen::Matrix<double, m, m>& noise);

  BodyNoise noise_;
  BodyState state_;
  bool begun_ = false;
  Covariance P_ = Covariance::Identity();  // at first, of the first frame's motion
};

}  // namespace delos::rigid_body
