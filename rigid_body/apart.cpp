#include "delos/rigid_body/apart.h"

#include "delos/rigid_body/refine.h"

namespace delos::rigid_body {

// All axes are alike: their covariances are multiples of I₃, and one number of each is
// enough.

void ApartFilter::move_origin(const Eigen::RowVector2d& h, const Eigen::Vector3d& left,
                              double variance) {
  const Eigen::Vector2d Ph = moving_ * h.transpose();
  const Eigen::Vector2d K = Ph / (h * Ph + variance);
  state_.v += K(0) * left;
  state_.a += K(1) * left;
  moving_ -= (K * Ph.transpose()).eval();
}

void ApartFilter::frame(double dt, const BodyPose& before, const BodyPose& after) {
  if (begun_) {
    state_.v += dt * state_.a;
    turning_ += noise_.omega;
    Eigen::Matrix2d F = Eigen::Matrix2d::Identity();
    F(0, 1) = dt;
    moving_ = (F * moving_ * F.transpose()).eval();
    moving_(0, 0) += noise_.v;
    moving_(1, 1) += noise_.a;
  }
  begun_ = true;
  gyroscope(turn_of(after.R * before.R.transpose()) / dt, 2 * noise_.turn / (dt * dt));
  const Eigen::RowVector2d h(dt, dt * dt / 2);
  move_origin(h, after.t - before.t - h(0) * state_.v - h(1) * state_.a,
              2 * noise_.place);
}

void ApartFilter::gyroscope(const Eigen::Vector3d& omega, double variance) {
  const double K = turning_ / (turning_ + variance);
  state_.omega += K * (omega - state_.omega);
  turning_ *= 1 - K;
}

void ApartFilter::accelerometer(const Eigen::Vector3d& acceleration, double variance) {
  move_origin({0, 1}, acceleration - state_.a, variance);
}

BodyPose ApartFilter::moved(double dt, double lag, const BodyPose& pose) const {
  return {turned_by(lag * state_.omega) * pose.R,
          pose.t + lag * (state_.v + dt * state_.a) + lag * lag / 2 * state_.a};
}

}  // namespace delos::rigid_body
