// No filter is better than the bound.
#include "simulation/simulated.h"

namespace delos::test {
namespace {

/// Ranges to three to six random beacons around the target.
System random_ranges(std::mt19937_64& random) {
  std::uniform_real_distribution<double> place_in(-3, 3), decades(-5, -3);
  std::uniform_int_distribution<int> count(3, 6), order(1, 2);
  System system;
  system.motion = chain_motion(PoseState::position, order(random),
                               Eigen::Vector3d(0.1, 0.2, 0.05).asDiagonal());
  system.markers = {Eigen::Vector3d::Zero()};
  const int devices = count(random);
  for (int i = 0; i < devices; ++i) {
    Eigen::Vector3d at(place_in(random), place_in(random), place_in(random));
    at += 1.5 * at.normalized();
    system.devices.push_back(
        place("r" + std::to_string(i),
              std::make_shared<TestFullRange>(std::pow(10, decades(random))),
              {Eigen::Matrix3d::Identity(), at}, 50));
  }
  return system;
}

/// The sum over the position of what was measured, and of the bound: 200 small scenes,
/// all filters in turn, two of the three errors of each scene's scatter below at most;
/// a scene in 740 is by chance.
TEST(Bound, IsBeatenByNoFilterOver200RandomScenes) {
  std::mt19937_64 random(42);
  double below = 0, total = 0;
  for (int i = 0; i < 200; ++i) {
    const System system = random_ranges(random);
    const Simulation s = simulate(system, kOrigin,
                                  {.runs = 24,
                                   .seed = static_cast<std::uint64_t>(i),
                                   .filter = static_cast<FilterKind>(i % 4),
                                   .seconds = 0.3});
    const SimulatedCovariance& c = s.covariances[0];
    ASSERT_EQ(c.bound.rows(), c.measured.rows());
    for (int k = 0; k < 3; ++k) {
      // The error is that which the bound's own variance would have.
      const double error = c.bound(k, k) * std::sqrt(2.0 / 24);
      EXPECT_GT(c.measured(k, k), c.bound(k, k) - 4.5 * error) << i << ", " << k;
      below += (c.measured(k, k) - c.bound(k, k)) / error;
      ++total;
    }
  }
  // And in the mean of all.
  EXPECT_GT(below / total, -4.5 / std::sqrt(total));
}

/// P∞ is the recursion's fixed point where the target stays in one place.
TEST(Bound, OfAPathThatStaysIsPInfinity) {
  System system = acoustic_system();
  const TargetPose pose{Eigen::Matrix3d::Identity(), {0.2, 0.2, 0.4}};
  GivenPath path{{0, 3}, {pose.p, pose.p}};
  const Simulation s = simulate(system, pose, {.runs = 4, .path = path});
  const SimulatedInstant& last = s.instants.back();
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(last.bound(k), s.covariances[0].predicted(k, k),
                1e-6 * s.covariances[0].predicted(k, k));
  EXPECT_LT((last.predicted - last.bound).norm(), 1e-6 * last.bound.norm());
}

}  // namespace
}  // namespace delos::test
