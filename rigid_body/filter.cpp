#include "delos/rigid_body/filter.h"

#include <Eigen/Cholesky>

#include "delos/rigid_body/motion.h"

namespace delos::rigid_body {

BodyPoints unit_points(const BodyPose& pose) {
  return {pose.R.col(0) + pose.t, pose.R.col(1) + pose.t, pose.R.col(2) + pose.t};
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

void BodyFilter::predict(double dt) {
  state_ = next(dt);
  Covariance H = Covariance::Identity();
  H.block<3, 3>(3, 6).diagonal().setConstant(dt);
  P_ = (H * P_ * H.transpose()).eval();
  P_.diagonal().segment<3>(0).array() += noise_.omega;
  P_.diagonal().segment<3>(3).array() += noise_.v;
  P_.diagonal().segment<3>(6).array() += noise_.a;
}

void BodyFilter::frame(double dt, const BodyPoints& before, const BodyPoints& after) {
  if (begun_) predict(dt);
  begun_ = true;
  const PointResidual r = point_residual(state_, dt, before, after);
  const Covariance JP = r.slope * P_;
  Covariance S = JP * r.slope.transpose();
  const Eigen::Matrix3d of_point =
      noise_.point * (r.W * r.W.transpose() + Eigen::Matrix3d::Identity());
  for (int i = 0; i < 3; ++i) S.block<3, 3>(3 * i, 3 * i) += of_point;
  const Eigen::LDLT<Covariance> split(S);
  const Eigen::Matrix<double, 9, 1> change = -JP.transpose() * split.solve(r.f);
  state_.omega += change.segment<3>(0);
  state_.v += change.segment<3>(3);
  state_.a += change.segment<3>(6);
  P_ -= (JP.transpose() * split.solve(JP)).eval();
  P_ = ((P_ + P_.transpose()) / 2).eval();
}

}  // namespace delos::rigid_body
