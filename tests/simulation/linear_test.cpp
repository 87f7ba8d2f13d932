// Linear systems: what filters reach on simulated readings is P∞, to within the scatter
// of the runs, which theory gives. P∞ comes from the Riccati solvers, which know no
// run, no reading and no filter.
#include "simulation/simulated.h"

namespace delos::test {
namespace {

Simulation simulated(const System& system, int runs = 2000, double seconds = 0) {
  return simulate(system, kOrigin, {.runs = runs, .seed = 7, .seconds = seconds});
}

TEST(Linear, StackedPriorAndPosteriorAreReached) {
  System system = moving(2, {axis(0, 1e-3, 50), axis(1, 4e-3, 50), axis(2, 1e-3, 50)});
  const Simulation s = simulated(system);
  ASSERT_EQ(s.covariances.size(), 2u);
  EXPECT_EQ(s.covariances[0].name, "prior");
  expect_predicted(s);
  expect_settled(s);
  EXPECT_TRUE(s.instants.back().nees.inside()) << s.instants.back().nees.mean;
  EXPECT_TRUE(s.instants.back().nis.inside()) << s.instants.back().nis.mean;
  EXPECT_EQ(s.instants.back().nees.expected, 6);
  EXPECT_EQ(s.instants.back().nis.expected, 3);
  // 95 % of instants in a two-sided 95 % band; they are correlated, hence no count.
  EXPECT_GT(s.nees_inside, 0.7);
  // It begins with twice the deviations, and forgets them by its time constant: the
  // variance's excess, 3 e^(−2t/T), is below 10 % after 1.7 T; runs scatter.
  ASSERT_TRUE(s.settled_after);
  EXPECT_GT(*s.settled_after, 0.5 * s.time_constant);
  EXPECT_LT(*s.settled_after, 3 * s.time_constant);
}

TEST(Linear, ErrorsHaveTheStandardErrorOfNormalOnes) {
  const Simulation s =
      simulated(moving(1, {axis(0, 1e-3, 50), axis(1, 4e-3, 50), axis(2, 1e-3, 50)}));
  const SimulatedCovariance& c = s.covariances[0];
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(c.error(i, i), c.predicted(i, i) * std::sqrt(2.0 / 2000),
                0.12 * c.error(i, i));
}

TEST(Linear, PeriodicAverageAndExtremesAreReachedByManyRates) {
  const System system = moving(2,
                               {axis(0, 1e-3, 50), axis(1, 1e-3, 20, 0.003),
                                axis(2, 1e-3, 25, 0.01), axis(1, 1e-2, 100)},
                               Fusion::periodic);
  const Simulation s = simulated(system, 2000);
  ASSERT_EQ(s.covariances.size(), 3u);
  EXPECT_EQ(s.covariances[0].name, "average");
  expect_predicted(s);
  expect_settled(s);
  EXPECT_LT(s.covariances[2].measured(0, 0), s.covariances[1].measured(0, 0));
}

TEST(Linear, SequentialTurnsAreReached) {
  const System system = moving(
      2, {axis(0, 1e-3, 90), axis(1, 4e-3, 90), axis(2, 1e-3, 60)}, Fusion::sequential);
  const Simulation s = simulated(system, 2000);
  ASSERT_EQ(s.covariances.size(), 4u);
  expect_predicted(s);
  expect_settled(s);
}

TEST(Linear, ReadingsThatTakeTimeAreReached) {
  const System one = moving(2, {axis(0, 1e-4, 30, 0, 0.03), axis(1, 1e-4, 30, 0, 0.03),
                                axis(2, 1e-4, 30, 0, 0.03)});
  const Simulation s = simulated(one, 1000);
  expect_predicted(s);
  // Of different exposures, windows that overlap.
  const System many = moving(2,
                             {axis(0, 1e-4, 30, 0, 0.02), axis(1, 1e-4, 60, 0, 0.01),
                              axis(2, 1e-4, 60), axis(0, 1e-3, 60)},
                             Fusion::periodic);
  expect_predicted(simulated(many, 1000));
}

TEST(Linear, BiasesOfTheDevicesOwnAreReached) {
  // A reading of the acceleration, off by a bias that drifts within a second.
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(3, 9);
  H.rightCols(3).setIdentity();
  std::vector<OwnState> bias;
  for (const char* name : {"bx", "by", "bz"})
    bias.push_back({name, "m/s^2", 1.0, 0.02});
  System system = moving(3, {axis(0, 1e-4, 50), axis(1, 1e-4, 50), axis(2, 1e-4, 50),
                             place("a",
                                   std::make_shared<StateReading>(
                                       H, 1e-2 * Eigen::MatrixXd::Identity(3, 3), bias),
                                   {}, 50)});
  add_own(system, 3);
  const Simulation s = simulated(system, 500);
  EXPECT_EQ(s.covariances[0].predicted.rows(), 12);
  expect_predicted(s);
  EXPECT_TRUE(s.instants.back().nees.inside()) << s.instants.back().nees.mean;
}

TEST(Linear, CorrelatedNoiseIsDrawnAndUnderstood) {
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(3, 6), R(3, 3);
  H.leftCols(3).setIdentity();
  R << 2, 1, 0.5, 1, 3, -1, 0.5, -1, 1;
  const System system =
      moving(2, {place("all", std::make_shared<StateReading>(H, 1e-3 * R), {}, 50)});
  const Simulation s = simulated(system, 1000);
  expect_predicted(s);
  expect_settled(s);
  EXPECT_TRUE(s.instants.back().nis.inside());
}

TEST(Linear, ThreadsGiveTheSameBytes) {
  const System system = acoustic_system();
  const TargetPose pose{Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.4}};
  const auto run = [&](int threads) {
    return simulate(system, pose,
                    {.runs = 70, .seed = 3, .seconds = 0.2, .threads = threads});
  };
  const Simulation one = run(1), three = run(3);
  EXPECT_EQ(one.covariances[0].measured, three.covariances[0].measured);
  EXPECT_EQ(one.covariances[0].bound, three.covariances[0].bound);
  EXPECT_EQ(one.instants.back().nis.mean, three.instants.back().nis.mean);
  const Simulation other =
      simulate(system, pose, {.runs = 70, .seed = 4, .seconds = 0.2});
  EXPECT_NE(one.covariances[0].measured, other.covariances[0].measured);
}

}  // namespace
}  // namespace delos::test
