// The papers' approximations of readings that take time: R with so much more, of a
// reading of one instant.
#include <gtest/gtest.h>

#include "support/rigs.h"

namespace delos {
namespace {

using testing::state_at;
using testing::TestLinear;

CoordinateMatrix approximated_noise() {
  Eigen::Matrix3d q;
  q << 0.4, 0.1, 0, 0.1, 0.3, -0.05, 0, -0.05, 0.1;
  return q;
}

System exposing_system(int order, const Eigen::MatrixXd& R, double exposure) {
  System system;
  system.motion =
      testing::chain_motion(PoseState::position, order, approximated_noise());
  system.markers = {Eigen::Vector3d::Zero()};
  system.devices = {testing::place(
      "a", std::make_shared<TestLinear>(Span::point, Eigen::Matrix3d::Identity(), R),
      Pose{}, 50)};
  system.devices[0].exposure = exposure;
  return system;
}

/// Terms of Welch et al. (2007), Eqs. 4–6, 8 and 9, and theory: written out.
double term(ExposureModel model, int k, double t) {
  const double end[] = {t, t * t * t / 3, t * t * t * t * t / 20};
  const double mean[] = {t / 3, t * t * t / 20, t * t * t * t * t / 252};
  switch (model) {
    case ExposureModel::instantaneous:
      return end[k - 1];
    case ExposureModel::averaged:
      return end[k - 1] / 4;
    case ExposureModel::integrated:
      return t * t * mean[k - 1];
    case ExposureModel::exact:
      break;
  }
  return mean[k - 1];
}

TEST(Approximations, HaveTheirVariances) {
  for (const ExposureModel model : {ExposureModel::exact, ExposureModel::instantaneous,
                                    ExposureModel::averaged, ExposureModel::integrated})
    for (const int k : {1, 2, 3})
      EXPECT_NEAR(motion_variance(model, k, 0.7), term(model, k, 0.7), 1e-15);
}

/// A device whose R has the motion's part, by both solvers; and beside one that exposes
/// for another time, so that nothing is reduced.
TEST(Approximations, AddTheirVarianceToR) {
  const Eigen::Matrix3d R = Eigen::Vector3d(1e-4, 3e-4, 1e-3).asDiagonal();
  const double tau = 0.013;
  for (const ExposureModel model : {ExposureModel::instantaneous,
                                    ExposureModel::averaged, ExposureModel::integrated})
    for (const int k : {1, 2, 3}) {
      const auto expanded = [&](double t) {
        return Eigen::MatrixXd(R + term(model, k, t) * approximated_noise());
      };
      System system = exposing_system(k, R, tau),
             plain = exposing_system(k, expanded(tau), 0);
      system.exposures = model;
      for (const Solver solver : {Solver::spectral, Solver::doubling}) {
        const FusedState got = state_at(system, {}, solver), want = state_at(plain, {});
        EXPECT_LT((got.prior - want.prior).norm(), 1e-10 * want.prior.norm());
        EXPECT_LT((got.posterior - want.posterior).norm(), 1e-10 * want.prior.norm());
        EXPECT_NEAR(got.time_constant, want.time_constant, 1e-7 * want.time_constant);
      }
      const System other = exposing_system(k, R, 0.02),
                   other_plain = exposing_system(k, expanded(0.02), 0);
      system.devices.push_back(other.devices[0]);
      plain.devices.push_back(other_plain.devices[0]);
      const FusedState got = state_at(system, {}), want = state_at(plain, {});
      EXPECT_LT((got.prior - want.prior).norm(), 1e-10 * want.prior.norm());
    }
}

}  // namespace
}  // namespace delos
