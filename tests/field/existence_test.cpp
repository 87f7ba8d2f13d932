// Conditions of a steady state: undriven modes against the rank test of Popov,
// Belevitch and Hautus, and what a scene is told.
#include "delos/field/existence.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "delos/riccati/existence.h"
#include "support/rigs.h"

namespace delos {
namespace {

/// Modes μ of A, |μ| ≥ 1, at which [A − μI, Q] loses rank: by singular values, which
/// undriven_modes() doesn't use.
int undriven_by_rank(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q) {
  const Eigen::Index n = A.rows();
  int count = 0;
  for (const std::complex<double> mu : Eigen::VectorXcd(A.eigenvalues())) {
    if (std::abs(mu) < 1 - 1e-9) continue;
    Eigen::MatrixXcd test(n, 2 * n);
    test << A.cast<std::complex<double>>() - mu * Eigen::MatrixXcd::Identity(n, n),
        Q.cast<std::complex<double>>();
    const Eigen::VectorXd s = Eigen::JacobiSVD<Eigen::MatrixXcd>(test).singularValues();
    count += s(n - 1) < 1e-9 * s(0);
  }
  return count;
}

TEST(Undriven, AgreesWithTheRankTest) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const auto matrix = [&](int rows, int columns) {
    Eigen::MatrixXd m(rows, columns);
    for (double& x : m.reshaped()) x = normal(random);
    return m;
  };
  int with = 0, without = 0;
  for (int i = 0; i < 200; ++i) {
    // Modes 1.1, 1, 0.5 and −1 of which some are driven, seen from random axes.
    const Eigen::Vector4d mu(1.1, 1, 0.5, -1);
    Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
    bool circle = false;
    for (int k = 0; k < 4; ++k) {
      noise(k, k) = random() % 2;
      circle = circle || (noise(k, k) == 0 && std::abs(mu(k)) == 1);
    }
    const Eigen::Matrix4d T = matrix(4, 4) + 3 * Eigen::Matrix4d::Identity();
    const Eigen::Matrix4d A = T * mu.asDiagonal() * T.inverse(),
                          Q = T * noise * T.transpose();
    const UndrivenModes modes = undriven_modes({A, (Q + Q.transpose()) / 2});
    const int expected = undriven_by_rank(A, Q);
    ASSERT_EQ(modes.directions.cols(), expected);
    EXPECT_EQ(modes.on_circle, circle);
    for (int k = 0; k < expected; ++k) {
      const Eigen::VectorXd w = modes.directions.col(k);
      EXPECT_NEAR(w.norm(), 1, 1e-12);
      EXPECT_LE((Q * w).norm(), 1e-9 * Q.norm());
    }
    ++(expected > 0 ? with : without);
  }
  EXPECT_GT(with, 20);
  EXPECT_GT(without, 20);
}

// A chain is driven from end to end; a constant bias by nothing; a decaying one dies
// out.
TEST(Undriven, IsWhatOneExpectsOfMotions) {
  for (const int order : {1, 2, 3}) {
    const MotionModel chain =
        testing::chain_motion(PoseState::pose, order, CoordinateMatrix::Identity(6, 6));
    EXPECT_EQ(undriven_modes(discretize(chain, 1e-3)).directions.cols(), 0);
  }
  for (const auto& [mu, undriven, circle] :
       {std::tuple{1.0, 1, true}, {0.99, 0, false}, {1.5, 1, false}}) {
    MotionStep step{StateMatrix::Identity(4, 4), StateMatrix::Identity(4, 4)};
    step.A(3, 3) = mu;
    step.Q(3, 3) = 0;
    const UndrivenModes modes = undriven_modes(step);
    EXPECT_EQ(modes.directions.cols(), undriven);
    EXPECT_EQ(modes.on_circle, circle);
    if (undriven > 0) {
      EXPECT_NEAR(std::abs(modes.directions(3, 0)), 1, 1e-12);
    }
  }
}

/// A scene of the system's samples alone: what existence() reads of it.
Scene scene_at(const Samples& samples) {
  Scene scene;
  scene.samples = {{"", PointSampling{"", samples.points}}};
  return scene;
}

TEST(Existence, CountsWhereEveryModeIsSeen) {
  System system = testing::acoustic_system();
  for (PlacedDevice& device : system.devices)
    device.device = std::make_shared<testing::TestRange>(0.005, 0.75);
  const Samples samples = testing::volume({0, 0, 0}, {0.4, 0.4, 0.8}, 0.2);
  const Scene scene = scene_at(samples);
  const Existence found = existence(scene, system, 1000);
  const Field field =
      evaluate_field(system, samples, {}, testing::metric_of(system, "eigmax"));
  EXPECT_EQ(found.places, samples.points.size());
  EXPECT_EQ(found.detectable,
            static_cast<std::size_t>(
                std::count(field.observable.begin(), field.observable.end(), 1)));
  EXPECT_GT(found.detectable, 0u);
  EXPECT_LT(found.detectable, found.places);
  EXPECT_TRUE(found.stabilizable);
  EXPECT_EQ(existence(scene, system, 7).places, 7u);
  EXPECT_NE(to_string(found).find(", stabilizable"), std::string::npos);

  system.fusion = Fusion::artemis;
  EXPECT_EQ(existence(scene, system, 10).places, 0u);
}

TEST(Existence, NamesTheStatesThatNoNoiseDrives) {
  System system = testing::acoustic_system();
  system.motion.layout = {.pose = PoseState::position, .order = 1, .extra = {"bias"}};
  StateMatrix Q = 1e-4 * StateMatrix::Identity(4, 4);
  Q(3, 3) = 0;
  system.motion.dynamics = CustomMotion{StateMatrix::Identity(4, 4), Q};
  const Scene scene = scene_at(testing::points({{0.1, 0.2, 0.3}}));
  const Existence found = existence(scene, system, 10);
  EXPECT_EQ(found.undriven, std::vector<std::string>{"bias"});
  EXPECT_EQ(
      to_string(found),
      "detectable at none of the places tried (1), not stabilizable: no noise drives "
      "bias, whose variance goes to 0 ever more slowly");
}

}  // namespace
}  // namespace delos
