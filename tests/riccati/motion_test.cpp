// Discretisation of the integrator chains, and the names of the state.
#include "delos/model/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

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

/// Of a drift and a density.
MotionStep step_of(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q, double dt) {
  MotionModel model;
  model.layout.pose = PoseState::none;
  model.dynamics = ContinuousMotion{A, Q};
  return discretize(model, dt);
}

// Expected: the closed form of the chain, entry by entry, over twelve decades of dt.
TEST(ContinuousMotion, OfAChainIsTheChain) {
  testing::Draw draw(4);
  for (int k = 1; k <= 3; ++k) {
    const auto chain = chain_model(k, draw.spd(3));
    const MotionStep c = continuous_form(chain);
    for (const double dt : {1e-6, 1e-3, 0.3, 7.0, 1e6}) {
      const MotionStep expected = discretize(chain, dt), step = step_of(c.A, c.Q, dt);
      for (int i = 0; i < 3 * k; ++i)
        for (int j = 0; j < 3 * k; ++j) {
          EXPECT_NEAR(step.A(i, j), expected.A(i, j),
                      1e-14 * std::abs(expected.A(i, j)));
          EXPECT_NEAR(step.Q(i, j), expected.Q(i, j),
                      1e-14 * std::abs(expected.Q(i, j)));
        }
    }
  }
}

// dx/dt = −a x + w:  Φ = e^(−a dt),  Q = q (1 − e^(−2a dt))/(2a), where a plain
// exponential of [a, q; 0, −a] dt has lost all digits as well, and for a mode that
// grows.
TEST(ContinuousMotion, OfOneStateIsItsClosedForm) {
  for (const double a : {1e-9, 0.5, 40.0, 3000.0, -2.0}) {
    const double dt = 0.7, q = 3;
    const MotionStep step = step_of(Eigen::MatrixXd::Constant(1, 1, -a),
                                    Eigen::MatrixXd::Constant(1, 1, q), dt);
    EXPECT_NEAR(step.A(0, 0), std::exp(-a * dt), 1e-12 * std::exp(-a * dt));
    const double Q = -q * std::expm1(-2 * a * dt) / (2 * a);
    EXPECT_NEAR(step.Q(0, 0), Q, 1e-12 * Q);
  }
}

// Expected: Van Loan's blocks of one matrix exponential, by Eigen's Padé approximant.
TEST(ContinuousMotion, IsTheExponentialOfVanLoansMatrix) {
  testing::Draw draw(5);
  for (const int n : {1, 2, 5, 12}) {
    const Eigen::MatrixXd A = draw.matrix(n, n), Q = draw.spd(n);
    const double dt = 0.4;
    Eigen::MatrixXd M(2 * n, 2 * n);
    M << -A, Q, Eigen::MatrixXd::Zero(n, n), A.transpose();
    const Eigen::MatrixXd E = (dt * M).exp();
    const Eigen::MatrixXd transition = E.bottomRightCorner(n, n).transpose();
    const MotionStep step = step_of(A, Q, dt);
    EXPECT_LT(testing::relative(step.A, transition), 1e-13) << n;
    EXPECT_LT(testing::relative(step.Q, transition * E.topRightCorner(n, n)), 1e-12)
        << n;
  }
}

TEST(StateLayout, OfAPlaneHasNeitherHeightNorTilt) {
  const StateLayout planar{PoseState::planar, 2, {}};
  EXPECT_EQ(planar.names(), (std::vector<std::string>{"x", "y", "vx", "vy"}));
  EXPECT_EQ(planar.units(), (std::vector<std::string>{"m", "m", "m/s", "m/s"}));
  EXPECT_EQ(planar.positions(), 2);
  EXPECT_EQ(planar.turns(), 0);
  const StateLayout pose{PoseState::planar_pose, 3, {"bias"}};
  EXPECT_EQ(pose.names(), (std::vector<std::string>{"x", "y", "yaw", "vx", "vy", "vyaw",
                                                    "ax", "ay", "ayaw", "bias"}));
  EXPECT_EQ(pose.units()[5], "rad/s");
  EXPECT_EQ(pose.size(), 10);
  EXPECT_EQ(pose.turns(), 1);
  const StateLayout none{PoseState::none, 1, {"level"}};
  EXPECT_EQ(none.names(), std::vector<std::string>{"level"});
  EXPECT_EQ(none.block(), 0);
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
