#include "delos/rigid_body/refine.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "delos/rigid_body/motion.h"

namespace delos::rigid_body {

Eigen::Matrix3d turned_by(const Eigen::Vector3d& turn) {
  return body_motion(turn, 1).W;
}

Eigen::Vector3d turn_of(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

std::optional<MeasuredPose> refined(const BodyPose& from,
                                    std::span<const Eigen::Vector3d> body,
                                    const std::vector<Camera>& cameras,
                                    std::span<const MarkerImage> images, double sigma) {
  MeasuredPose best{from};
  Eigen::Matrix<double, 6, 6> N;
  for (int step = 0; step < 10; ++step) {
    N.setZero();
    Eigen::Matrix<double, 6, 1> g = Eigen::Matrix<double, 6, 1>::Zero();
    for (const MarkerImage& image : images) {
      const Eigen::Vector3d arm = best.pose.R * body[image.marker];
      Eigen::Matrix<double, 2, 3> of_point;
      const auto uv =
          image_of(cameras[image.seen.camera], arm + best.pose.t, &of_point);
      if (!uv) return std::nullopt;
      Eigen::Matrix<double, 2, 6> J;
      J << of_point, -of_point * skew(arm);
      N += J.transpose() * J;
      g += J.transpose() * (image.seen.uv - *uv);
    }
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> split(N);
    if (!(split.vectorD().minCoeff() > 1e-9 * split.vectorD().maxCoeff()))
      return std::nullopt;
    const Eigen::Matrix<double, 6, 1> change = split.solve(g);
    best.pose.t += change.head<3>();
    best.pose.R = (turned_by(change.tail<3>()) * best.pose.R).eval();
    if (change.norm() < 1e-10) break;
  }
  best.covariance = sigma * sigma * N.inverse();
  return best;
}

}  // namespace delos::rigid_body
