// Metrics against their definitions, written out for a diagonal covariance.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "delos/steady/state_metric.h"

namespace delos {
namespace {

StateLayout pv(PoseState pose) {
  StateLayout layout;
  layout.pose = pose;
  layout.order = 2;
  return layout;
}

Metric metric(const std::string& name, const StateLayout& layout) {
  return std::get<Metric>(parse_metric(name, layout));
}

double value(const std::string& name, const StateLayout& layout,
             const FusedState& state) {
  return state_metric(metric(name, layout), layout, state, CovarianceKind::prior, {});
}

FusedState diagonal(const Eigen::VectorXd& variances) {
  FusedState state;
  state.prior = variances.asDiagonal();
  state.posterior = (0.5 * variances).asDiagonal();
  state.unobservable.resize(variances.size(), 0);
  return state;
}

TEST(Metric, FollowsTheDefinitions) {
  const StateLayout layout = pv(PoseState::position);
  Eigen::VectorXd v(6);
  v << 1, 4, 9, 16, 25, 36;
  const FusedState state = diagonal(v);
  EXPECT_DOUBLE_EQ(value("sigma_y", layout, state), 2);
  EXPECT_DOUBLE_EQ(value("sigma_vz", layout, state), 6);
  EXPECT_DOUBLE_EQ(value("sigma_position", layout, state), std::sqrt(14));
  EXPECT_DOUBLE_EQ(value("eigmax", layout, state), 3);
  EXPECT_DOUBLE_EQ(value("eiglen", layout, state), std::pow(1 + 16 + 81, 0.25));
  EXPECT_DOUBLE_EQ(value("trace", layout, state), 14);
  EXPECT_DOUBLE_EQ(value("det", layout, state), 36);
  const double det = 1. * 4 * 9 * 16 * 25 * 36;
  EXPECT_NEAR(value("mle", layout, state),
              std::pow(2 * std::numbers::pi, -3) / std::sqrt(det), 1e-18);
  EXPECT_DOUBLE_EQ(state_metric(metric("trace", layout), layout, state,
                                CovarianceKind::posterior, {}),
                   7);
}

TEST(Metric, OfAPoseReadsItsOwnBlock) {
  const StateLayout layout = pv(PoseState::pose);
  Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(12, 1, 12);
  const FusedState state = diagonal(v);
  EXPECT_DOUBLE_EQ(value("sigma_orientation", layout, state), std::sqrt(4 + 5 + 6));
  EXPECT_DOUBLE_EQ(value("eigmax", layout, state), std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(value("sigma_yaw", layout, state), std::sqrt(6.0));
  EXPECT_DOUBLE_EQ(value("sigma_vroll", layout, state), std::sqrt(10.0));
  EXPECT_DOUBLE_EQ(
      value("eigmax", pv(PoseState::orientation), diagonal(Eigen::VectorXd::Ones(6))),
      1);
}

TEST(Metric, CarriesItsUnit) {
  const StateLayout position = pv(PoseState::position), pose = pv(PoseState::pose),
                    turn = pv(PoseState::orientation);
  EXPECT_EQ(metric("eigmax", position).unit, "m");
  EXPECT_EQ(metric("eigmax", turn).unit, "rad");
  EXPECT_EQ(metric("sigma_vyaw", pose).unit, "rad/s");
  EXPECT_EQ(metric("det", position).unit, "m^6");
  EXPECT_EQ(metric("latency", position).unit, "s");
  EXPECT_EQ(metric("coverage", position).unit, "1");
  EXPECT_EQ(metric("mle", position).unit, "m^-6 s^3");
  EXPECT_EQ(metric("mle", pose).unit, "m^-6 rad^-6 s^6");
  EXPECT_TRUE(metric("mle", position).larger_is_better);
  EXPECT_FALSE(metric("eigmax", position).larger_is_better);
}

TEST(Metric, ThatTheStateLacksIsRefusedWithTheListOfThoseThere) {
  StateLayout layout;
  const auto answer = parse_metric("sigma_vx", layout);
  ASSERT_TRUE(std::holds_alternative<std::string>(answer));
  EXPECT_EQ(std::get<std::string>(answer),
            "unknown metric 'sigma_vx'; this state has sigma_x sigma_y sigma_z "
            "sigma_horizontal sigma_position eigmax eiglen mle trace det coverage "
            "footprint latency nonlinearity unscented_ratio");
}

TEST(Metric, IsInfiniteOnlyWhereItReadsALostDirection) {
  const StateLayout layout = pv(PoseState::position);
  FusedState state = diagonal(Eigen::VectorXd::Ones(6));
  state.status = RiccatiStatus::unobservable;
  state.unobservable = StateMatrix::Zero(6, 1);
  state.unobservable(2, 0) = 1;
  EXPECT_DOUBLE_EQ(value("sigma_x", layout, state), 1);
  EXPECT_TRUE(std::isinf(value("sigma_z", layout, state)));
  EXPECT_TRUE(std::isinf(value("eigmax", layout, state)));
  EXPECT_TRUE(std::isinf(value("mle", layout, state)));
}

// The largest eigenvalue of a nearly double one, known by construction.
TEST(Metric, EigMaxKeepsItsDigitsAtNearlyEqualEigenvalues) {
  const StateLayout layout = pv(PoseState::position);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  FusedState state = diagonal(Eigen::VectorXd::Ones(6));
  const Eigen::Vector3d eigenvalues(1e-9, 4, 4 * (1 + 1e-12));
  state.prior.topLeftCorner<3, 3>() =
      turn * eigenvalues.asDiagonal() * turn.transpose();
  EXPECT_NEAR(value("eigmax", layout, state), 2 * (1 + 0.5e-12), 4e-15);
}

}  // namespace
}  // namespace delos
