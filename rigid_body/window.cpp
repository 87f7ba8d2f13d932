#include "delos/rigid_body/window.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "delos/rigid_body/motion.h"

namespace delos::rigid_body {

MeasuredPose predicted_pose(const BodyFilter& filter, double dt,
                            const MeasuredPose& last) {
  const BodyState state = filter.next(dt);
  const BodyMotion m = body_motion(state.omega, dt);
  const BodyMotionSlopes by =
      body_motion_slopes(state.omega, dt, last.pose.t, state.v, state.a);
  Eigen::Matrix<double, 6, 9> J = Eigen::Matrix<double, 6, 9>::Zero();
  J.topRows<3>() << by.W + by.V + by.A, m.V, m.A;
  J.bottomLeftCorner<3, 3>() = m.V;
  Eigen::Matrix<double, 6, 6> of_pose = Eigen::Matrix<double, 6, 6>::Zero();
  of_pose.topLeftCorner<3, 3>() = of_pose.bottomRightCorner<3, 3>() = m.W;
  return {moved(state, dt, last.pose),
          J * filter.next_covariance(dt) * J.transpose() +
              of_pose * last.covariance * of_pose.transpose()};
}

double SearchWindow::distance(const Eigen::Vector2d& uv) const {
  const Eigen::Vector2d off = uv - centre;
  return off.dot(covariance.inverse() * off);
}

std::optional<SearchWindow> search_window(const Camera& camera,
                                          const MeasuredPose& predicted,
                                          const Eigen::Vector3d& marker, double sigma) {
  const Eigen::Vector3d arm = predicted.pose.R * marker;
  Eigen::Matrix<double, 2, 3> F;
  const auto uv = image_of(camera, arm + predicted.pose.t, &F);
  if (!uv) return std::nullopt;
  Eigen::Matrix<double, 2, 6> J;
  J << F, -F * skew(arm);
  return SearchWindow{*uv, J * predicted.covariance * J.transpose() +
                               sigma * sigma * Eigen::Matrix2d::Identity()};
}

}  // namespace delos::rigid_body
