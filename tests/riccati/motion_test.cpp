// Discretisation of the integrator chains, and the names of the state.
#include "delos/model/motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "riccati/systems.h"

namespace delos {
namespace {

using testing::chain_model;

// Expected: the definition, A = exp(F dt) and Q = ∫ exp(F s) G q Gᵀ exp(F s)ᵀ ds,
// summed as a Taylor series (F is nilpotent) and by Gauss–Legendre on three nodes,
// exact to degree 5.
TEST(Motion, DiscretisesTheContinuousChain) {
  testing::Draw draw(1);
  for (int k = 1; k <= 3; ++k) {
    const auto model = chain_model(k, draw.spd(3));
    const MotionStep c = continuous_form(model);
    const double dt = 0.3;
    const auto exponential = [&](double t) -> Eigen::MatrixXd {
      const Eigen::MatrixXd F = c.A;
      return Eigen::MatrixXd::Identity(3 * k, 3 * k) + F * t + F * F * t * t / 2;
    };
    Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(3 * k, 3 * k);
    const double nodes[] = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)};
    const double weights[] = {5.0 / 18, 4.0 / 9, 5.0 / 18};
    for (int i = 0; i < 3; ++i) {
      const Eigen::MatrixXd E = exponential(nodes[i] * dt);
      Q += dt * weights[i] * E * c.Q * E.transpose();
    }
    const MotionStep step = discretize(model, dt);
    EXPECT_LT((step.A - exponential(dt)).norm(), 1e-15);
    EXPECT_LT(testing::relative(step.Q, Q), 1e-15 * 4);
  }
}

// Two half steps are one step: A = A₂A₁, Q = A₂Q₁A₂ᵀ + Q₂.
TEST(Motion, StepsCompose) {
  testing::Draw draw(2);
  const auto model = chain_model(3, draw.spd(6));
  const MotionStep a = discretize(model, 0.1), b = discretize(model, 0.25),
                   c = discretize(model, 0.35);
  EXPECT_LT(testing::relative(b.A * a.A, c.A), 1e-15);
  EXPECT_LT(testing::relative(b.A * a.Q * b.A.transpose() + b.Q, c.Q), 1e-14);
}

TEST(Motion, CustomModelIsOneUpdateWhateverItsDuration) {
  MotionModel model;
  model.dynamics =
      CustomMotion{StateMatrix::Identity(4, 4), 2 * StateMatrix::Identity(4, 4)};
  const MotionStep step = discretize(model, 123);
  EXPECT_EQ(step.A, StateMatrix::Identity(4, 4));
  EXPECT_EQ(step.Q, 2 * StateMatrix::Identity(4, 4));
}

TEST(StateLayout, NamesAndUnitsFollowTheStateVector) {
  const StateLayout pose{PoseState::pose, 3, {"gyro_bias_x"}};
  const std::vector<std::string> names{
      "x",  "y",     "z",      "roll",   "pitch",      "yaw", "vx",
      "vy", "vz",    "vroll",  "vpitch", "vyaw",       "ax",  "ay",
      "az", "aroll", "apitch", "ayaw",   "gyro_bias_x"};
  EXPECT_EQ(pose.names(), names);
  EXPECT_EQ(pose.units().size(), names.size());
  EXPECT_EQ(pose.units()[2], "m");
  EXPECT_EQ(pose.units()[3], "rad");
  EXPECT_EQ(pose.units()[8], "m/s");
  EXPECT_EQ(pose.units()[17], "rad/s^2");
  EXPECT_EQ(pose.units()[18], "1");

  const StateLayout turn{PoseState::orientation, 1, {}};
  EXPECT_EQ(turn.names(), (std::vector<std::string>{"roll", "pitch", "yaw"}));
  EXPECT_EQ(turn.units(), (std::vector<std::string>{"rad", "rad", "rad"}));
}

}  // namespace
}  // namespace delos
