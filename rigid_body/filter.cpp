#include "delos/rigid_body/filter.h"

#include <Eigen/Cholesky>

#include "delos/rigid_body/motion.h"

namespace delos::rigid_body {

BodyPoints unit_points(const BodyPose& pose) {
  return {pose.R.col(0) + pose.t, pose.R.col(1) + pose.t, pose.R.col(2) + pose.t};
}

BodyPoints virtual_points(const BodyPose& pose, double arm) {
  return unit_points({arm * pose.R, pose.t});
}

BodyPose moved(const BodyState& state, double dt, const BodyPose& pose) {
  const BodyMotion m = body_motion(state.omega, dt);
  return {m.W * pose.R, m.W * pose.t + m.V * state.v + m.A * state.a};
}

Eigen::Vector3d moved(const BodyState& state, double dt, const Eigen::Vector3d& p) {
  return moved(state, dt, BodyPose{Eigen::Matrix3d::Identity(), p}).t;
}

BodyPoints moved(const BodyState& state, double dt, const BodyPoints& points) {
  return {moved(state, dt, points[0]), moved(state, dt, points[1]),
          moved(state, dt, points[2])};
}

PointResidual point_residual(const BodyState& state, double dt,
                             const BodyPoints& before, const BodyPoints& after) {
  PointResidual out;
  const BodyMotion m = body_motion(state.omega, dt);
  out.W = m.W;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    out.f.segment<3>(3 * i) =
        m.W * before[k] + m.V * state.v + m.A * state.a - after[k];
    const BodyMotionSlopes by =
        body_motion_slopes(state.omega, dt, before[k], state.v, state.a);
    out.slope.middleRows<3>(3 * i) << by.W + by.V + by.A, m.V, m.A;
  }
  return out;
}

BodyState BodyFilter::next(double dt) const {
  return {state_.omega, state_.v + dt * state_.a, state_.a};
}

BodyFilter::Covariance BodyFilter::next_covariance(double dt) const {
  Covariance H = Covariance::Identity();
  H.block<3, 3>(3, 6).diagonal().setConstant(dt);
  Covariance P = H * P_ * H.transpose();
  P.diagonal().segment<3>(0).array() += noise_.omega;
  P.diagonal().segment<3>(3).array() += noise_.v;
  P.diagonal().segment<3>(6).array() += noise_.a;
  return P;
}

void BodyFilter::coast(double dt) {
  P_ = next_covariance(dt);
  state_ = next(dt);
}

/// The update by f(s) = 0 but for noise: K = P Jᵀ (J P Jᵀ + N)⁻¹, s ← s − K f.
template <int m>
void BodyFilter::update(const Eigen::Matrix<double, m, 1>& f,
                        const Eigen::Matrix<double, m, 9>& slope,
                        const Eigen::Matrix<double, m, m>& noise) {
  const Eigen::Matrix<double, m, 9> JP = slope * P_;
  const Eigen::Matrix<double, m, m> S = JP * slope.transpose() + noise;
  const Eigen::LDLT<Eigen::Matrix<double, m, m>> split(S);
  const Eigen::Matrix<double, 9, 1> change = -JP.transpose() * split.solve(f);
  state_.omega += change.segment<3>(0);
  state_.v += change.segment<3>(3);
  state_.a += change.segment<3>(6);
  P_ -= (JP.transpose() * split.solve(JP)).eval();
  P_ = ((P_ + P_.transpose()) / 2).eval();
}

void BodyFilter::frame(double dt, const BodyPoints& before, const BodyPoints& after) {
  if (begun_) coast(dt);
  begun_ = true;
  const PointResidual r = point_residual(state_, dt, before, after);
  Covariance noise = Covariance::Zero();
  const Eigen::Matrix3d of_point =
      noise_.point * (r.W * r.W.transpose() + Eigen::Matrix3d::Identity());
  for (int i = 0; i < 3; ++i) noise.block<3, 3>(3 * i, 3 * i) = of_point;
  update<9>(r.f, r.slope, noise);
}

void BodyFilter::gyroscope(const Eigen::Vector3d& omega, double variance) {
  Eigen::Matrix<double, 3, 9> J = Eigen::Matrix<double, 3, 9>::Zero();
  J.leftCols<3>().setIdentity();
  update<3>(state_.omega - omega, J, variance * Eigen::Matrix3d::Identity());
}

void BodyFilter::accelerometer(double dt, const Eigen::Vector3d& p,
                               const Eigen::Vector3d& acceleration, double variance) {
  const Eigen::Matrix3d w = skew(state_.omega);
  const Eigen::Vector3d velocity = w * p + state_.v + dt * state_.a;
  Eigen::Matrix<double, 3, 9> J;
  J << -skew(velocity) - w * skew(p), w, dt * w + Eigen::Matrix3d::Identity();
  update<3>(w * velocity + state_.a - acceleration, J,
            variance * Eigen::Matrix3d::Identity());
}

}  // namespace delos::rigid_body
