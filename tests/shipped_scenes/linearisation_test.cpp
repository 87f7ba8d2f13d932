// What `nonlinearity` foretells: where it says that linearising leaves little out, the
// extended filter's NEES is in its band, and where it says otherwise, it isn't.
#include <algorithm>

#include "delos/simulation/simulate.h"
#include "shipped.h"

namespace delos::test {
namespace {

using Changes = std::vector<Override>;

struct Case {
  std::string name, scene;
  Eigen::Vector3d at;
  double noise = 1, motion = 1;  ///< times every device's variance, and q
  int runs = 600;
  double seconds = 0;
  Changes changes = {};
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

/// Where the metric is at most this the filter is right, and from the other on wrong.
/// Between them it depends on what else bends.
constexpr double kLinear = 0.06, kBent = 0.1;

System system_of(const Case& c) {
  System system = build_system(load(c.scene, c.changes), plugins());
  for (PlacedDevice& placed : system.devices) placed.noise *= c.noise;
  std::get<ChainMotion>(system.motion.dynamics).q *= c.motion;
  return system;
}

/// The target's first orientation in a scene.
Eigen::Vector3d turn_of(const Case& c) {
  const auto turns = load(c.scene, c.changes).orientations.rpy;
  return turns.empty() ? Eigen::Vector3d::Zero().eval() : turns.front();
}

double nonlinearity_of(const Case& c, const System& system) {
  Orientations turned;
  turned.rpy = {turn_of(c)};
  return evaluate_field(
             system, make_samples({{"", PointSampling{"", {c.at}}}}), turned,
             std::get<Metric>(parse_metric("nonlinearity", system.motion.layout)))
      .value[0];
}

/// What an extended filter does.
struct Outcome {
  /// NEES over its expectation, less 1, in its standard deviations: √(2/(N n)) of
  /// χ²/(N n). Of runs that end near the target.
  double excess = 0;
  double lost = 0;  ///< part of the runs that don't
  /// Two-sided, 99.9 %: of these cases none leaves it by chance.
  [[nodiscard]] bool right() const { return std::abs(excess) < 3.3 && lost < 0.02; }
};

Outcome outcome_of(const Case& c, const System& system) {
  const TargetPose pose{rotation_from_rpy(turn_of(c)), c.at};
  const Simulation s = simulate(
      system, pose, {.runs = c.runs, .seed = 1, .seconds = c.seconds, .threads = 2});
  const double lost = static_cast<double>(s.lost) / static_cast<double>(s.runs);
  if (s.instants.empty()) return {NAN, lost};  // all of them
  const Consistency& nees = s.instants.back().nees;
  const auto tracked = static_cast<double>(s.runs - s.lost);
  return {(nees.mean / nees.expected - 1) / std::sqrt(2 / (tracked * nees.expected)),
          lost};
}

class Linearisation : public ::testing::TestWithParam<Case> {};

// Where the target's motion is what isn't known before an update, linearising shows
// after it.
const Changes kTracking = {{"covariance", "prior"}},
              kAfter = {{"covariance", "posterior"}};

TEST_P(Linearisation, IsAsBadAsTheMetricSays) {
  const Case& c = GetParam();
  const System system = system_of(c);
  const double bent = nonlinearity_of(c, system);
  const Outcome outcome = outcome_of(c, system);
  const bool should_hold = c.noise == 1 && c.motion == 1;
  if (should_hold)
    EXPECT_LT(bent, kLinear);
  else
    EXPECT_GT(bent, kBent);
  EXPECT_GT(bent, 0);
  EXPECT_EQ(outcome.right(), should_hold)
      << bent << ": " << outcome.excess << ", " << outcome.lost;
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Linearisation,
    ::testing::Values(
        Case{"acoustic", "01-acoustic", {0.2, 0.2, 0.4}},
        Case{"acoustic_bent", "01-acoustic", {0.2, 0.2, 0.4}, 100},
        Case{"cameras", "05-optitrack-lab", {0, 0, 1.5}, 1, 1, 600, 0.5},
        Case{"cameras_bent", "05-optitrack-lab", {0, 0, 1.5}, 1, 1e4, 300, 0, kAfter},
        Case{"hiball", "hiball/six-lepd", {4.5, 7.5, 1.9}, 1, 1, 200, 0.15},
        Case{"hiball_bent", "hiball/six-lepd", {4.5, 7.5, 1.9}, 1, 1e6, 200, 0.05},
        Case{"radio", "15-uwb-anchors", {4, 3, 1.5}, 1, 1, 600, 0.8},
        Case{"radio_bent", "15-uwb-anchors", {4, 3, 1.5}, 1000, 1, 400},
        Case{"bearings", "18-floor-robot", {3, 3, 0}, 1, 1, 600, 0, kTracking},
        Case{"bearings_bent", "18-floor-robot", {3, 3, 0}, 1, 1e6, 400, 0, kAfter}),
    [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace delos::test
