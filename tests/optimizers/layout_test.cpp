// Layouts: assignments against all permutations, and layouts that are the same but for
// who is called what.
#include "delos/optimize/layout.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>

#include "optimizers/circle.h"
#include "problem/assignment.h"

namespace delos::test {
namespace {

TEST(Assignment, IsTheCheapestOfAllPermutations) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-5, 5);
  for (int n = 1; n <= 7; ++n) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      // Small whole numbers now and then, which make ties.
      const Eigen::MatrixXd cost = Eigen::MatrixXd::NullaryExpr(n, n, [&] {
        return repeat % 2 == 0 ? number(random) : std::round(number(random) / 2);
      });
      const auto sum = [&](const std::vector<std::size_t>& to) {
        double all = 0;
        for (std::size_t i = 0; i < to.size(); ++i)
          all += cost(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(to[i]));
        return all;
      };
      std::vector<std::size_t> to(static_cast<std::size_t>(n));
      std::iota(to.begin(), to.end(), std::size_t{0});
      double least = sum(to);
      const std::vector<std::size_t> identity = to;
      while (std::next_permutation(to.begin(), to.end()))
        least = std::min(least, sum(to));
      std::vector<std::size_t> found = cheapest_assignment(cost);
      EXPECT_NEAR(sum(found), least, 1e-12 * (1 + std::abs(least)));
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, identity);
    }
  }
}

TEST(Assignment, RefusesWhatHasNoLeastSum) {
  for (const double wrong : {double{NAN}, double{INFINITY}, -double{INFINITY}, 1e301}) {
    Eigen::MatrixXd cost = Eigen::MatrixXd::Ones(3, 3);
    cost(1, 2) = wrong;
    EXPECT_THROW((void)cheapest_assignment(cost), std::invalid_argument) << wrong;
    cost.row(1).setConstant(wrong);
    EXPECT_THROW((void)cheapest_assignment(cost), std::invalid_argument) << wrong;
  }
}

std::vector<Pose> poses_of(const Scene& scene) {
  std::vector<Pose> poses;
  for (const DeviceEntry& device : scene.devices)
    poses.push_back(device_pose(scene, device));
  return poses;
}

TEST(Layouts, OfPermutedCamerasAreTheSame) {
  const Scene room = load("09-camera-room");
  const std::vector<int> kinds = device_kinds(room, plugins());
  // Eight cameras that variables zoom: one kind.
  EXPECT_EQ(kinds, std::vector<int>(8, 0));
  const std::vector<Pose> first = poses_of(room);
  const std::vector<std::size_t> order = {3, 1, 7, 0, 2, 6, 4, 5};
  std::vector<Pose> second;
  for (const std::size_t i : order) second.push_back(first[i]);
  const LayoutMatch match = match_layouts(kinds, first, second, {3, 2.5, 1});
  EXPECT_EQ(match.distance, 0);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(order[match.partner[i]], i);
}

TEST(Layouts, OfDifferentKindsAreNotMixed) {
  const Scene pair = parse(kOneTarget + R"(devices:
  - {name: a, rate: 50, type: acoustic_range, at: [1, 0, 0], params: {r: 0.01}}
  - {name: b, rate: 50, type: acoustic_range, at: [0, 1, 0], params: {r: 0.02}}
  - {name: c, rate: 50, type: acoustic_range, at: [0, 0, 1], params: {r: 0.01}}
)");
  EXPECT_EQ(device_kinds(pair, plugins()), (std::vector<int>{0, 1, 0}));
  const std::vector<Pose> first = poses_of(pair);
  const std::vector<Pose> second = {first[1], first[0], first[2]};
  const LayoutMatch match =
      match_layouts({0, 1, 0}, first, second, Eigen::Vector3d::Zero());
  // b has no other of its kind, and a went where b was: √2 each, over three devices.
  EXPECT_NEAR(match.distance, std::sqrt(4.0 / 3), 1e-12);
}

/// A camera that turns on the spot by φ moves what it looks at by r φ.
TEST(Layouts, CountTurnsByTheirArms) {
  Pose a, b;
  a.p = b.p = {0, 0, -4};
  const double turn = 0.2;
  b.R = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const LayoutMatch match = match_layouts({0}, {a}, {b}, Eigen::Vector3d::Zero());
  EXPECT_NEAR(match.turn[0], turn, 1e-12);
  EXPECT_NEAR(match.distance, 4 * turn, 1e-12);
  // A turn about the line of sight changes no place that is looked at.
  b.R = Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_NEAR(match_layouts({0}, {a}, {b}, Eigen::Vector3d::Zero()).distance, 0, 1e-12);
}

// Three speakers on a circle, one fixed at 0°: the best is at 60° and 120°, where each
// may also stand on the other side of the target.
TEST(Consensus, KnowsTheSameLayoutAndWhatIsFree) {
  const Scene scene = parse(circle({0, 60, 120}, true));
  const std::vector<RankedDesign> designs = {{{60 / 360.0, 120 / 360.0}, 1.0},
                                             {{120 / 360.0, 60 / 360.0}, 1.0},
                                             {{240 / 360.0, 120 / 360.0}, 1.1},
                                             {{240.5 / 360.0, 120 / 360.0}, 1.2}};
  const Consensus all = consensus(scene, plugins(), designs);
  ASSERT_EQ(all.layouts.size(), 2u);
  EXPECT_EQ(all.layouts[0].design, 0u);
  EXPECT_EQ(all.layouts[1].design, 2u);
  EXPECT_NEAR(all.layouts[1].distance, std::sqrt(2.0 * 2.0 / 4), 1e-3);
  const auto device = [&](const std::string& name) {
    for (const ConsensusDevice& d : all.devices)
      if (d.name == name) return d;
    ADD_FAILURE() << name;
    return ConsensusDevice{};
  };
  EXPECT_EQ(device("d2").settled, Settled::settled);
  EXPECT_NEAR(device("d2").shift, 0, 1e-12);
  EXPECT_EQ(device("d1").settled, Settled::free);
  EXPECT_NEAR(device("d1").shift, 2, 1e-3);  // to the other side of the circle
}

/// Two designs that differ by a half of one device's shift and a twentieth of its turn,
/// and by 0.12 of another's shift. Uniform numbers vary about a half by 1/√12; a turn
/// counts with the 2 m from the device to the middle.
TEST(Consensus, WeighsTurnsByWhatTheyMoveAndKnowsWhatIsPartlySettled) {
  const Scene scene = parse(R"(delos: 1
name: Two speakers
motion: {type: position, q: [0.4, 0.4, 0.4]}
sample: {points: [[0, 0, 0]]}
devices:
  - {name: turned, rate: 50, at: [2, 0, 0], rpy: [0, 0, 0], type: acoustic_range, params: {r: 0.01}}
  - {name: shifted, rate: 50, at: [0, 2, 0], type: acoustic_range, params: {r: 0.02}}
variables:
  - {path: devices.turned.at.z, lower: -1, upper: 1}
  - {path: devices.turned.rpy.pitch, lower: -45 deg, upper: 45 deg}
  - {path: devices.shifted.at.z, lower: -1, upper: 1}
objective: {minimize: mean, of: eigmax, guess: 100}
)");
  const Consensus all =
      consensus(scene, plugins(), {{{0.5, 0.5, 0.5}, 1.0}, {{1.0, 0.55, 0.62}, 1.1}});
  ASSERT_EQ(all.layouts.size(), 2u);
  ASSERT_EQ(all.devices.size(), 2u);
  const ConsensusDevice &turned = all.devices[0], &shifted = all.devices[1];
  const double range = std::numbers::pi / 2;
  EXPECT_NEAR(turned.shift, 1, 1e-9);
  EXPECT_NEAR(turned.turn, 0.05 * range, 1e-9);
  // Mean squares of a hundred numbers: known within 9 %, their roots within 4.5 %.
  EXPECT_NEAR(
      turned.part_of_chance,
      std::hypot(1, 2 * 0.05 * range) / (std::hypot(2, 2 * range) / std::sqrt(12.0)),
      0.12);
  EXPECT_EQ(turned.settled, Settled::free);
  EXPECT_NEAR(shifted.part_of_chance, 0.12 * std::sqrt(12.0), 0.06);
  EXPECT_EQ(shifted.settled, Settled::partly);
}

TEST(Consensus, OfOneLayoutKeepsJustThat) {
  const Scene scene = parse(circle({0, 60, 120}, true));
  const Consensus all = consensus(scene, plugins(), {{{0.1, 0.4}, 1.0}}, 10);
  EXPECT_EQ(all.layouts.size(), 1u);
}

}  // namespace
}  // namespace delos::test
