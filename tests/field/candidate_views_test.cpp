// What candidates see, against devices that are asked about every pose by themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "delos/geometry/body.h"
#include "delos/layers/candidate_information.h"
#include "rig/sight.h"
#include "support/rigs.h"

namespace delos {
namespace {

/// Sees what is in a cone about its z axis and within reach; says so of balls, or not.
/// Without an entry for many points.
class Cone final : public Device {
 public:
  Cone(double half_angle, double reach, bool tells)
      : half_angle_(half_angle), reach_(reach), tells_(tells) {}
  bool observe(const Target& target, Observation& out) const override {
    const double range = target.p_ST.norm();
    if (!(range > 0 && range <= reach_) || angle(target.p_ST) > half_angle_)
      return false;
    out.z.setConstant(1, range);
    out.H = target.p_ST.transpose() / range;
    out.R.setConstant(1, 1, 1);
    return true;
  }
  View view_of_ball(const Eigen::Vector3d& center, double radius) const override {
    if (!tells_) return View::unknown;
    const double range = center.norm();
    if (range > reach_ + radius) return View::outside;
    if (range <= radius) return View::crossing;
    const double own = angle(center), half = std::asin(radius / range);
    if (own > half_angle_ + half + 1e-9) return View::outside;
    return own + half < half_angle_ - 1e-9 && range + radius < reach_ ? View::inside
                                                                      : View::crossing;
  }

 private:
  static double angle(const Eigen::Vector3d& p) {
    return std::atan2(p.head<2>().norm(), p.z());
  }
  double half_angle_, reach_;
  bool tells_;
};

/// A scene by chance: what stands where, what hides, which poses.
struct Chance {
  System system;
  CandidateScene all;
  std::vector<TargetPose> poses;
};

Chance by_chance(std::uint64_t seed, bool in_world, bool on_target) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto within = [&](double side) {
    return Eigen::Vector3d(side * unit(random), side * unit(random),
                           side * unit(random));
  };
  Chance chance;
  System& system = chance.system;
  system.motion =
      testing::chain_motion(PoseState::position, 1, CoordinateMatrix::Identity(3, 3));
  system.markers = {{0, 0, 0}, {0.2, -0.1, 0.1}};
  if (seed % 2) system.markers.pop_back();
  std::vector<TriangleMesh> bodies;
  for (int i = 0; i < 4; ++i) {
    TriangleMesh body =
        body_mesh(BoxShape{{0, 0, 0}, Eigen::Vector3d(0.2, 0.2, 0.2) + within(1)});
    bodies.push_back(transformed(body, {testing::random_rotation(random), within(4)}));
  }
  if (in_world) system.in_world = Occluders(bodies);
  if (on_target)
    system.on_target =
        Occluders({body_mesh(BoxShape{{-0.1, -0.1, -0.3}, {0.1, 0.1, -0.1}})});

  // Spots with several facings, as cameras have; two stand there whatever is chosen.
  Eigen::Vector3d spot = within(4);
  for (int i = 0; i < 40; ++i) {
    if (i % 4 == 0) spot = within(4);
    const Pose X{testing::random_rotation(random), spot};
    const double reach = 1 + 3 * unit(random);
    std::shared_ptr<const Device> device;
    if (i % 5 == 0)
      device = std::make_shared<testing::TestFullRange>(0.1, reach);
    else
      device = std::make_shared<Cone>(0.2 + unit(random), reach, i % 5 != 1);
    if (i == 7)
      device = std::make_shared<testing::TestLinear>(
          Span::pose, Eigen::MatrixXd::Identity(3, 6), Eigen::MatrixXd::Identity(3, 3));
    system.devices.push_back(testing::place("d", device, X, 10));
    if (i % 6 == 2) system.devices.back().lenses.emplace_back(0.4, 0.1, 0);
    const bool always = i == 11 || i == 30;
    chance.all.of_device.push_back(
        always ? -1 : static_cast<int>(chance.all.candidates.size()));
    if (!always) chance.all.candidates.emplace_back();
  }
  // A grid, on whose planes boxes of the tree end, and points by chance; three
  // orientations in turn.
  std::vector<Eigen::Matrix3d> turns = {Eigen::Matrix3d::Identity(),
                                        testing::random_rotation(random),
                                        testing::random_rotation(random)};
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3d p =
        i < 1728 ? Eigen::Vector3d(i % 12, i / 12 % 12, i / 144) / 3 : within(4);
    chance.poses.push_back({turns[static_cast<std::size_t>(i) % turns.size()], p});
  }
  return chance;
}

/// By the definition: some marker is in view, and nothing in the way.
bool sees(const System& system, const PlacedDevice& placed, const TargetPose& X_WT) {
  const Pose X_SW = placed.X_WS().inverse();
  Observation out;
  Target target;
  target.R_ST = X_SW.R * X_WT.R;
  if (placed.device->span() != Span::point) {
    target.p_ST = X_SW * X_WT.p;
    return placed.device->observe(target, out);
  }
  for (const PlacedMarker& marker : system.markers) {
    target.p_ST = X_SW * (X_WT * marker.p);
    if (placed.device->observe(target, out) && in_sight(system, placed, X_WT, marker))
      return true;
  }
  return false;
}

void expect_the_definition(const Chance& chance) {
  const CandidateViews views =
      candidate_views(chance.system, chance.all, chance.poses, 2);
  ASSERT_EQ(views.first.size(), chance.all.candidates.size() + 1);
  std::vector<std::int32_t> always(chance.poses.size(), 0);
  std::size_t sightings = 0;
  for (std::size_t d = 0; d < chance.system.devices.size(); ++d) {
    std::vector<std::int32_t> seen;
    for (std::size_t p = 0; p < chance.poses.size(); ++p)
      if (sees(chance.system, chance.system.devices[d], chance.poses[p]))
        seen.push_back(static_cast<std::int32_t>(p));
    sightings += seen.size();
    const int c = chance.all.of_device[d];
    if (c < 0) {
      for (const std::int32_t p : seen) ++always[static_cast<std::size_t>(p)];
      continue;
    }
    const auto own = [&](std::size_t i) {
      return views.poses.begin() +
             static_cast<std::ptrdiff_t>(views.first[static_cast<std::size_t>(c) + i]);
    };
    EXPECT_EQ(std::vector<std::int32_t>(own(0), own(1)), seen) << "device " << d;
  }
  EXPECT_EQ(views.always, always);
  // Neither nothing nor everything.
  const std::size_t most = chance.system.devices.size() * chance.poses.size();
  EXPECT_GT(sightings, most / 100);
  EXPECT_LT(sightings, most / 2);
}

TEST(CandidateViews, AreWhatDevicesSayPoseByPose) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const bool in_world : {false, true})
      for (const bool on_target : {false, true}) {
        SCOPED_TRACE("seed " + std::to_string(seed) + (in_world ? ", bodies" : "") +
                     (on_target ? ", one on the target" : ""));
        expect_the_definition(by_chance(seed, in_world, on_target));
      }
}

TEST(CandidateViews, AreTheSameForAnyNumberOfThreads) {
  const Chance chance = by_chance(3, true, true);
  const CandidateViews one =
      candidate_views(chance.system, chance.all, chance.poses, 1);
  for (const int threads : {2, 3, 8}) {
    const CandidateViews several =
        candidate_views(chance.system, chance.all, chance.poses, threads);
    EXPECT_EQ(several.first, one.first);
    EXPECT_EQ(several.poses, one.poses);
    EXPECT_EQ(several.always, one.always);
  }
}

/// Counts what it is asked.
class Counting final : public RangeDevice {
 public:
  Counting() : RangeDevice(1, 0, 1) {}
  bool observe_lanes(const PointLanes& points, RowLanes& out) const override {
    asked += points.count;
    return RangeDevice::observe_lanes(points, out);
  }
  mutable std::atomic<int> asked = 0;
};

// Of 29,791 poses in a room of 30 m, a reach of 1 m crosses a few boxes of 64.
TEST(CandidateViews, AskAboutFewPoses) {
  Chance chance;
  chance.system.motion =
      testing::chain_motion(PoseState::position, 1, CoordinateMatrix::Identity(3, 3));
  chance.system.markers = {{0, 0, 0}};
  const auto device = std::make_shared<Counting>();
  chance.system.devices = {
      testing::place("d", device, {Eigen::Matrix3d::Identity(), {15, 15, 15}}, 1)};
  chance.all.of_device = {0};
  chance.all.candidates.emplace_back();
  for (int i = 0; i < 31 * 31 * 31; ++i)
    chance.poses.push_back(
        {Eigen::Matrix3d::Identity(), Eigen::Vector3d(i % 31, i / 31 % 31, i / 961)});
  const CandidateViews views =
      candidate_views(chance.system, chance.all, chance.poses, 1);
  // The six neighbours; at the device itself a range has no direction.
  EXPECT_EQ(views.poses.size(), 6u);
  EXPECT_LE(device->asked, 16 * 64);
  EXPECT_GE(device->asked, 7);
}

TEST(CandidateViews, TellHowFarTheyAreAndStop) {
  Chance chance = by_chance(1, false, false);
  const std::size_t many = 20;  // more than one thread does at a time
  const std::vector<PlacedDevice> devices = chance.system.devices;
  const std::vector<int> of_device = chance.all.of_device;
  const auto candidates = static_cast<int>(chance.all.candidates.size());
  for (std::size_t k = 1; k < many; ++k) {
    for (std::size_t d = 0; d < devices.size(); ++d) {
      chance.system.devices.push_back(devices[d]);
      chance.all.of_device.push_back(
          of_device[d] < 0 ? -1 : of_device[d] + static_cast<int>(k) * candidates);
    }
  }
  chance.all.candidates.resize(many * static_cast<std::size_t>(candidates));
  std::vector<double> parts;
  const auto views = [&](double until) {
    parts.clear();
    return candidate_views(chance.system, chance.all, chance.poses, 1,
                           [&](double part) {
                             parts.push_back(part);
                             return part < until;
                           });
  };
  EXPECT_FALSE(views(2).first.empty());
  EXPECT_GT(parts.size(), 3u);
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_EQ(parts.back(), 1);
  EXPECT_TRUE(views(0.5).first.empty());
  EXPECT_LT(parts.back(), 1);
}

}  // namespace
}  // namespace delos
