// Devices on the target: which beacons they see, use, and what that tells of the pose.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <set>

#include "delos/device/beacons.h"
#include "delos/geometry/primitives.h"
#include "delos/layers/layers.h"
#include "delos/observe/beacon_use.h"
#include "support/rigs.h"

namespace delos {
namespace {

using Eigen::Vector3d;

Vector3d random_vector(std::mt19937_64& random, double scale) {
  std::uniform_real_distribution<double> uniform(-scale, scale);
  return {uniform(random), uniform(random), uniform(random)};
}

std::vector<Beacon> cloud(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Beacon> beacons(count);
  for (Beacon& b : beacons) {
    b.p = random_vector(random, 3);
    b.normal = random_vector(random, 1).normalized();
    b.cos_emission = 0.2;
    b.range = 2 + 2 * uniform(random);
    b.weight = uniform(random);
  }
  return beacons;
}

// ---- the index ----

TEST(BeaconIndex, FindsWhatALoopOverAllFinds) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const std::size_t count : {1u, 8u, 9u, 3000u}) {
    const std::vector<Beacon> beacons = cloud(count, count);
    const BeaconIndex index(beacons);
    std::size_t total = 0;
    for (int trial = 0; trial < 500; ++trial) {
      ViewCone cone;
      cone.apex = random_vector(random, 4);
      cone.axis = random_vector(random, 1).normalized();
      cone.half_angle = trial % 10 == 0 ? 4 : 3.1 * std::pow(uniform(random), 2);
      if (trial % 3 == 0) cone.range = 3 * uniform(random);
      std::set<std::size_t> expected, found;
      for (std::size_t i = 0; i < count; ++i) {
        const Vector3d way = beacons[i].p - cone.apex;
        const double angle =
            std::atan2(cone.axis.cross(way).norm(), cone.axis.dot(way));
        if (angle <= cone.half_angle && way.norm() <= cone.range) expected.insert(i);
      }
      std::vector<std::uint32_t> in_cone;
      index.find(cone, in_cone);
      for (const std::uint32_t i : in_cone) found.insert(index.listed(i));
      EXPECT_EQ(found.size(), in_cone.size());
      EXPECT_EQ(found, expected);
      total += found.size();
    }
    EXPECT_GT(total, 0u);
  }
}

// All of the cones that come of moving one's apex by up to so many metres: a beacon in
// one of them must be found near the first. Nobody is found whom the criterion of the
// search, s cos θ − a sin θ ≤ metres at depth a and s beside the axis, rules out.
TEST(BeaconIndex, FindsNearWhatMovedConesHold) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  const std::vector<Beacon> beacons = cloud(3000, 1);
  const BeaconIndex index(beacons);
  EXPECT_GT(index.patch(), 0);
  std::size_t moved_in = 0;
  for (int trial = 0; trial < 300; ++trial) {
    ViewCone cone;
    cone.apex = random_vector(random, 4);
    cone.axis = random_vector(random, 1).normalized();
    cone.half_angle = 1.4 * uniform(random);
    if (trial % 3 == 0) cone.range = 3 * uniform(random);
    const double metres = 0.5 * uniform(random);
    std::vector<std::uint32_t> near;
    index.find_near(cone, metres, near);
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    const std::set<std::uint32_t> found(near.begin(), near.end());
    EXPECT_EQ(found.size(), near.size());
    for (const std::uint32_t i : near) {
      const Vector3d way = index[i].p - cone.apex;
      const double a = cone.axis.dot(way), s = cone.axis.cross(way).norm();
      EXPECT_LE(s * std::cos(cone.half_angle) - a * std::sin(cone.half_angle),
                metres + 1e-3 * (1 + way.norm()));
      EXPECT_LE(way.norm(), cone.range + metres + 1e-3);
    }
    for (int move = 0; move < 20; ++move) {
      ViewCone moved = cone;
      moved.apex += metres * random_vector(random, 1).normalized();
      std::vector<std::uint32_t> held;
      index.find(moved, held);
      for (const std::uint32_t i : held) {
        EXPECT_TRUE(found.contains(i));
        const Vector3d way = index[i].p - cone.apex;
        moved_in += std::acos(cone.axis.dot(way) / way.norm()) > cone.half_angle;
      }
    }
  }
  EXPECT_GT(moved_in, 1000u);
}

TEST(BeaconIndex, OfNoBeaconsFindsNone) {
  std::vector<std::uint32_t> found;
  BeaconIndex({}).find({}, found);
  BeaconIndex({}).find_near({.half_angle = 0.1}, 1, found);
  EXPECT_TRUE(found.empty());
}

// ---- what is seen ----

/// Two cones that look along z and x, 40° wide and 4 m long, each of which reads a
/// beacon's two image coordinates; R grows with distance.
class TestViews : public Device {
 public:
  int views() const override { return 2; }
  ViewCone view_cone(int view) const override {
    return {apex(view), axis(view), 0.35, 4};
  }
  bool observe(const Target& target, Observation& out) const override {
    return observe_view(0, target, out) || observe_view(1, target, out);
  }
  bool observe_view(int view, const Target& target, Observation& out) const override {
    const Vector3d p = turn(view) * (target.p_ST - apex(view));
    if (!(p.z() > 0) || p.norm() > 4) return false;
    const double u = p.x() / p.z(), v = p.y() / p.z();
    if (u * u + v * v > std::tan(0.34) * std::tan(0.34)) return false;
    out.z.resize(2);
    out.z << u, v;
    Eigen::Matrix<double, 2, 3> H;
    H << 1 / p.z(), 0, -u / p.z(), 0, 1 / p.z(), -v / p.z();
    out.H = H * turn(view);
    // Correlated, so that whitening has something to do.
    out.R = 1e-6 * p.squaredNorm() * (Eigen::Matrix2d() << 2, 1, 1, 3).finished();
    return true;
  }
  static Vector3d apex(int view) {
    return view == 0 ? Vector3d(0, 0, 0.1) : Vector3d(0.1, 0, 0);
  }
  static Vector3d axis(int view) {
    return view == 0 ? Vector3d::UnitZ() : Vector3d::UnitX();
  }
  static Eigen::Matrix3d turn(int view) {
    return view == 0 ? Eigen::Matrix3d::Identity()
                     : Eigen::Matrix3d(Eigen::AngleAxisd(-M_PI / 2, Vector3d::UnitY()));
  }
};

/// The same with independent noise and the entry for many beacons.
class TestLaneViews final : public TestViews {
 public:
  bool observe_view(int view, const Target& target, Observation& out) const override {
    if (!TestViews::observe_view(view, target, out)) return false;
    out.R = Eigen::Matrix2d(out.R.diagonal().asDiagonal());
    return true;
  }
  bool observe_view_lanes(int view, const BeaconLanes& beacons,
                          RowLanes& out) const override {
    Target target;
    Observation one;
    out.rows = 2;
    for (int l = 0; l < beacons.count; ++l) {
      for (int i = 0; i < 3; ++i) target.p_ST(i) = beacons.p[i][l];
      out.seen[l] = observe_view(view, target, one);
      if (out.seen[l] == 0) continue;
      for (int r = 0; r < 2; ++r) {
        for (int i = 0; i < 3; ++i) out.H[r][i][l] = one.H(r, i);
        out.variance[r][l] = one.R(r, r);
      }
    }
    return true;
  }
};

System carried_system(PoseState pose, std::vector<Beacon> beacons,
                      SightingRule rule = SightingRule::all, int count = 1) {
  System system;
  const int d = pose == PoseState::pose ? 6 : 3;
  system.motion = testing::chain_motion(pose, 2, Eigen::MatrixXd::Identity(d, d) * 0.1);
  system.markers = {Vector3d::Zero()};
  PlacedDevice placed = testing::place("eye", std::make_shared<TestViews>(), {}, 100);
  placed.mount = TargetMount{{rotation_from_rpy({0.3, -0.2, 0.5}), {0.05, -0.1, 0.2}},
                             std::make_shared<BeaconIndex>(std::move(beacons)),
                             {},
                             rule,
                             count};
  system.devices.push_back(placed);
  return system;
}

std::vector<TargetPose> random_poses(int count) {
  std::mt19937_64 random(11);
  std::vector<TargetPose> poses;
  for (int i = 0; i < count; ++i) {
    poses.push_back({testing::random_rotation(random), random_vector(random, 2)});
  }
  return poses;
}

int view_of(const SeenBeacon& seen) { return seen.view == "view 1"; }

// The device's entries for one beacon and for many.
TEST(Beacons, FourTimesTheNoiseIsAQuarterOfTheInformation) {
  System system = carried_system(PoseState::pose, cloud(2000, 3));
  const std::vector<TargetPose> poses = random_poses(20);
  for (const bool lanes : {false, true}) {
    if (lanes) system.devices[0].device = std::make_shared<TestLaneViews>();
    System noisy = system;
    noisy.devices[0].noise = 4;
    const InformationLayers of_one(system, poses), of_other(noisy, poses);
    LayerBlock a, b;
    const std::vector<double>&one = of_one.block(0, a).total,
          &other = of_other.block(0, b).total;
    EXPECT_GT(*std::max_element(one.begin(), one.end()), 0);
    for (std::size_t e = 0; e < one.size(); ++e)
      EXPECT_NEAR(4 * other[e], one[e], 1e-14 * std::abs(one[e]));
  }
}

TEST(Beacons, AreSeenAsALoopOverAllBeaconsAndViewsSays) {
  const std::vector<Beacon> beacons = cloud(2000, 3);
  System system = carried_system(PoseState::pose, beacons);
  system.in_world = Occluders({make_box({-1, -1, -1}, {0.5, 0.5, 1})});
  system.on_target = Occluders({make_box({-0.3, -0.3, -0.6}, {0.3, 0.3, -0.3})});
  const TestViews device;
  std::size_t total = 0, hidden = 0;
  for (const TargetPose& pose : random_poses(500)) {
    const Pose X_WS = pose * system.devices[0].carried()->X_TS;
    using Key = std::tuple<int, double, double, double>;
    std::set<Key> expected, found;
    for (int view = 0; view < 2; ++view) {
      const Vector3d apex = X_WS * TestViews::apex(view);
      for (const Beacon& b : beacons) {
        Target target;
        target.p_ST = X_WS.inverse() * b.p;
        Observation out;
        if (!device.observe_view(view, target, out)) continue;
        const Vector3d way = apex - b.p;
        if (way.norm() > b.range || b.normal.dot(way) < 0.2 * way.norm()) continue;
        const Pose X_TW = pose.inverse();
        if (system.in_world.blocks(apex, b.p, system.skin) ||
            system.on_target.blocks(X_TW * apex, X_TW * b.p, system.skin)) {
          ++hidden;
          continue;
        }
        expected.insert({view, b.p.x(), b.p.y(), b.p.z()});
      }
    }
    for (const SeenBeacon& s : seen_beacons(system, pose)) {
      found.insert({view_of(s), s.at.x(), s.at.y(), s.at.z()});
      EXPECT_NEAR(s.distance, (s.at - X_WS * TestViews::apex(view_of(s))).norm(),
                  1e-12);
    }
    EXPECT_EQ(found, expected);
    total += found.size();
  }
  EXPECT_GT(total, 500u);
  EXPECT_GT(hidden, 100u);
}

// Rows over [δp, δθ] against central differences of the readings, the target moved and
// turned about the world's axes; R^(−1/2) taken off by comparing Hᵀ R⁻¹ H.
TEST(Beacons, RowsAreDerivativesByThePose) {
  const System system = carried_system(PoseState::pose, cloud(500, 4));
  const PlacedDevice& placed = system.devices[0];
  int compared = 0;
  for (const TargetPose& pose : random_poses(500)) {
    const WhitenedRows whitened = whitened_rows(system, pose);
    const std::vector<SeenBeacon> seen = seen_beacons(system, pose);
    ASSERT_EQ(whitened.rows.rows(), 2 * static_cast<Eigen::Index>(seen.size()));
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const auto observe = [&](const TargetPose& at, Observation& out) {
        Target target;
        target.p_ST = (at * placed.carried()->X_TS).inverse() * seen[i].at;
        return placed.device->observe_view(view_of(seen[i]), target, out);
      };
      Eigen::Matrix<double, 2, 6> J;
      const double h = 1e-6;
      bool inside = true;
      for (int c = 0; c < 6; ++c) {
        Observation plus, minus;
        for (Observation* out : {&plus, &minus}) {
          const double step = out == &plus ? h : -h;
          TargetPose moved = pose;
          if (c < 3) {
            moved.p(c) += step;
          } else {
            moved.R = Eigen::AngleAxisd(step, Vector3d::Unit(c - 3)) * pose.R;
          }
          inside = inside && observe(moved, *out);
        }
        if (!inside) break;
        J.col(c) = (plus.z - minus.z) / (2 * h);
      }
      if (!inside) continue;
      Observation here;
      ASSERT_TRUE(observe(pose, here));
      const Eigen::Matrix2d R = here.R;
      const Eigen::MatrixXd expected = J.transpose() * R.inverse() * J;
      // The weight of a sighting stands in its noise.
      const auto& rows = whitened.rows.middleRows(2 * static_cast<Eigen::Index>(i), 2);
      const Eigen::MatrixXd S = rows.transpose() * rows / seen[i].share;
      EXPECT_LT((S - expected).norm(), 1e-7 * expected.norm());
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(Beacons, LayersAreTheSumOfTheRows) {
  for (const PoseState state :
       {PoseState::position, PoseState::orientation, PoseState::pose}) {
    const System system = carried_system(state, cloud(800, 5), SightingRule::mean, 4);
    const std::vector<TargetPose> poses = random_poses(100);
    const InformationLayers layers(system, poses, {.threads = 1});
    LayerBlock scratch;
    for (std::size_t p = 0; p < poses.size(); ++p) {
      const LayerBlock& block = layers.block(p / kLanes, scratch);
      const WhitenedRows rows = whitened_rows(system, poses[p]);
      const Eigen::MatrixXd S = rows.rows.transpose() * rows.rows;
      for (int i = 0; i < S.rows(); ++i) {
        for (int j = 0; j <= i; ++j) {
          const auto e =
              static_cast<std::size_t>(packed_index(i, j)) * kLanes + p % kLanes;
          EXPECT_NEAR(block.total[e], S(i, j), 1e-11 * (1 + S.norm()));
        }
      }
      EXPECT_EQ((block.seen[0] >> (p % kLanes) & 1) != 0, rows.rows.rows() > 0);
    }
  }
}

/// Rows of poses a few centimetres apart, as fields have them, a few strewn ones, and
/// rows in another orientation.
std::vector<TargetPose> near_poses() {
  std::mt19937_64 random(13);
  std::vector<TargetPose> poses;
  for (int row = 0; row < 6; ++row) {
    const Eigen::Matrix3d R = testing::random_rotation(random);
    const Vector3d start = random_vector(random, 1.5),
                   step = random_vector(random, 0.1);
    for (int i = 0; i < 40; ++i) {
      poses.push_back({R, start + (i % 20) * step});
      if (i % 17 == 0) poses.push_back({R, random_vector(random, 2)});
    }
  }
  return poses;
}

/// Carried devices without and with an entry for many beacons.
std::vector<System> carried_systems(PoseState pose, const std::vector<Beacon>& beacons,
                                    SightingRule rule, int count) {
  std::vector<System> systems(2, carried_system(pose, beacons, rule, count));
  systems[1].devices[0].device = std::make_shared<TestLaneViews>();
  return systems;
}

// Beacons are looked for once for poses near each other. What a pose sees must not
// depend on that, to the last bit.
TEST(Beacons, InABlockAreThoseOfEachPoseAlone) {
  const std::vector<TargetPose> poses = near_poses();
  for (const System& system :
       carried_systems(PoseState::pose, cloud(3000, 14), SightingRule::mean, 4)) {
    const InformationLayers layers(system, poses, {.threads = 1});
    std::size_t seen = 0;
    LayerBlock a, b;
    for (std::size_t p = 0; p < poses.size(); ++p) {
      const InformationLayers alone(system, {poses[p]}, {.threads = 1});
      const LayerBlock& block = layers.block(p / kLanes, a);
      const LayerBlock& one = alone.block(0, b);
      for (std::size_t e = 0; e < one.total.size() / kLanes; ++e) {
        ASSERT_EQ(block.total[e * kLanes + p % kLanes], one.total[e * kLanes]);
      }
      ASSERT_EQ(block.seen[0] >> p % kLanes & 1, one.seen[0]);
      seen += one.seen[0];
    }
    EXPECT_GT(seen, 100u);
  }
}

// S = Σ w (H R_SW)ᵀ R⁻¹ H R_SW over every beacon that each view sees, by a loop over
// all.
TEST(Beacons, InABlockInformAsALoopOverAllBeaconsAndViewsSays) {
  const std::vector<Beacon> beacons = cloud(3000, 15);
  const std::vector<TargetPose> poses = near_poses();
  for (const System& system :
       carried_systems(PoseState::position, beacons, SightingRule::all, 1)) {
    const PlacedDevice& placed = system.devices[0];
    const InformationLayers layers(system, poses, {.threads = 1});
    LayerBlock scratch;
    for (std::size_t p = 0; p < poses.size(); ++p) {
      const Pose X_WS = poses[p] * placed.carried()->X_TS;
      Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
      for (int view = 0; view < 2; ++view) {
        const Vector3d apex = X_WS * TestViews::apex(view);
        for (const Beacon& b : beacons) {
          Target target;
          target.p_ST = X_WS.inverse() * b.p;
          Observation out;
          if (!placed.device->observe_view(view, target, out)) continue;
          const Vector3d way = apex - b.p;
          if (way.norm() > b.range || b.normal.dot(way) < 0.2 * way.norm()) continue;
          const Eigen::Matrix<double, 2, 3> H = out.H * X_WS.R.transpose();
          S += b.weight * H.transpose() * Eigen::Matrix2d(out.R).inverse() * H;
        }
      }
      const LayerBlock& block = layers.block(p / kLanes, scratch);
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j <= i; ++j) {
          const auto e =
              static_cast<std::size_t>(packed_index(i, j)) * kLanes + p % kLanes;
          ASSERT_NEAR(block.layers[e], S(i, j), 1e-11 * (1 + S.norm()));
        }
      }
    }
  }
}

TEST(Beacons, AChangedRuleRecomputesOneLayerAndThreadsChangeNothing) {
  System system = carried_system(PoseState::pose, cloud(800, 6));
  system.devices.push_back(system.devices.front());
  const std::vector<TargetPose> poses = random_poses(200);
  InformationLayers layers(system, poses, {.threads = 1});
  std::get<TargetMount>(system.devices[1].mount).select = SightingRule::nearest;
  EXPECT_EQ(layers.update(system), 1u);
  const InformationLayers fresh(system, poses, {.threads = 4});
  LayerBlock a, b;
  for (std::size_t i = 0; i < layers.block_count(); ++i) {
    EXPECT_EQ(layers.block(i, a).total, fresh.block(i, b).total);
  }
}

// ---- which are used ----

/// All shares at a pose that sees many beacons.
std::vector<SeenBeacon> shares(std::vector<Beacon> beacons, SightingRule rule,
                               int count, PoseState state = PoseState::position) {
  return seen_beacons(carried_system(state, std::move(beacons), rule, count),
                      {Eigen::Matrix3d::Identity(), {0, 0, -1}});
}

double total_share(const std::vector<SeenBeacon>& seen) {
  double sum = 0;
  for (const SeenBeacon& s : seen) sum += s.share;
  return sum;
}

std::vector<Beacon> plain_cloud(std::size_t count, std::uint64_t seed) {
  std::vector<Beacon> beacons = cloud(count, seed);
  for (Beacon& b : beacons) b = Beacon{.p = b.p};
  return beacons;
}

TEST(SightingRule, MeanAndRandomShareAmongAll) {
  const auto beacons = plain_cloud(1000, 7);
  const auto all = shares(beacons, SightingRule::all, 1);
  const auto n = static_cast<double>(all.size());
  ASSERT_GT(n, 20);
  for (const SeenBeacon& s : all) EXPECT_EQ(s.share, 1);
  for (const SeenBeacon& s : shares(beacons, SightingRule::mean, 5)) {
    EXPECT_NEAR(s.share, 5 / n, 1e-15);
  }
  for (const SeenBeacon& s : shares(beacons, SightingRule::random, 5)) {
    EXPECT_NEAR(s.share, 5 / n, 1e-15);
  }
  // More than there are: mean repeats some, random can't.
  EXPECT_NEAR(total_share(shares(beacons, SightingRule::mean, 1000)), 1000, 1e-9);
  EXPECT_NEAR(total_share(shares(beacons, SightingRule::random, 1000)), n, 1e-9);
}

TEST(SightingRule, NearestTakesTheNearest) {
  const auto beacons = cloud(3000, 8);  // of weights below 1
  const auto seen = shares(beacons, SightingRule::nearest, 6);
  ASSERT_GT(seen.size(), 20u);
  EXPECT_NEAR(total_share(seen), 6, 1e-12);
  double farthest_used = 0, nearest_left = 1e9;
  for (const SeenBeacon& s : seen) {
    if (s.share > 0) farthest_used = std::max(farthest_used, s.distance);
    if (s.share == 0) nearest_left = std::min(nearest_left, s.distance);
  }
  EXPECT_LT(farthest_used, nearest_left);
}

double log_det(const System& system, const TargetPose& pose) {
  const WhitenedRows rows = whitened_rows(system, pose);
  return std::log((rows.rows.transpose() * rows.rows).determinant());
}

// log det S is concave in the shares: no mixture with another way to share may be
// better than the best. Random ways, and corners, are tried.
TEST(SightingRule, BestIsNotBeatenByOtherShares) {
  std::mt19937_64 random(9);
  std::exponential_distribution<double> draw;
  for (const PoseState state : {PoseState::position, PoseState::pose}) {
    const auto beacons = plain_cloud(1500, 12);
    const TargetPose pose{Eigen::Matrix3d::Identity(), {0, 0, -1}};
    const int count = 8;
    const System best = carried_system(state, beacons, SightingRule::best, count);
    const auto seen = seen_beacons(best, pose);
    EXPECT_NEAR(total_share(seen), count, 1e-9);
    for (const SeenBeacon& s : seen) {
      EXPECT_GE(s.share, 0);
      EXPECT_LE(s.share, 1);
    }
    const double value = log_det(best, pose);
    for (const SightingRule rule :
         {SightingRule::random, SightingRule::mean, SightingRule::nearest}) {
      EXPECT_GT(value, log_det(carried_system(state, beacons, rule, count), pose));
    }
    const WhitenedRows rows =
        whitened_rows(carried_system(state, beacons, SightingRule::all), pose);
    const auto n = static_cast<Eigen::Index>(seen.size());
    for (int trial = 0; trial < 2000; ++trial) {
      Eigen::VectorXd share(n);
      for (double& s : share) s = draw(random);
      share = (share * count / share.sum()).cwiseMin(1.0);
      if (trial % 2 == 0) {  // near the best
        for (Eigen::Index i = 0; i < n; ++i) {
          share(i) = 0.95 * seen[static_cast<std::size_t>(i)].share + 0.05 * share(i);
        }
      }
      Eigen::MatrixXd S = Eigen::MatrixXd::Zero(rows.rows.cols(), rows.rows.cols());
      for (Eigen::Index i = 0; i < n; ++i) {
        const auto pair = rows.rows.middleRows(2 * i, 2);
        S += share(i) * pair.transpose() * pair;
      }
      EXPECT_LT(std::log(S.determinant()), value + 2e-5);
    }
  }
}

// More beacons leave what was there as a choice: what the best is best at can't fall.
// 2e-5 is twice the tolerance at which the search for the best stops.
TEST(SightingRule, MoreBeaconsNeverHurtTheBest) {
  std::mt19937_64 random(10);
  int improved = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto all = plain_cloud(1200, 20 + static_cast<std::uint64_t>(trial));
    const std::vector<Beacon> some(all.begin(), all.begin() + 600);
    const TargetPose pose{testing::random_rotation(random), {0, 0, 0}};
    const PoseState state = trial % 2 == 0 ? PoseState::position : PoseState::pose;
    const double few =
        log_det(carried_system(state, some, SightingRule::best, 10), pose);
    const double many =
        log_det(carried_system(state, all, SightingRule::best, 10), pose);
    if (!std::isfinite(few)) continue;
    EXPECT_GE(many, few - 2e-5);
    improved += many > few + 0.1;
  }
  EXPECT_GT(improved, 20);
}

// ---- words ----

TEST(BlindDevices, SayWhatIsInTheWay) {
  const std::vector<TargetPose> pose = {{Eigen::Matrix3d::Identity(), {0, 0, 0}}};
  const auto why = [&](std::vector<Beacon> beacons) {
    System system = carried_system(PoseState::pose, std::move(beacons));
    std::get<TargetMount>(system.devices[0].mount).X_TS = {};
    const auto reasons = blind_devices(system, pose);
    return reasons.empty() ? std::string() : reasons.front();
  };
  EXPECT_EQ(why({}), "eye sees no beacon from any sample: none is lit");
  EXPECT_EQ(why({Beacon{.p = {0, 0, -2}}}),
            "eye sees no beacon from any sample: none of 1 is in a view's cone; look "
            "where the device and its views face");
  EXPECT_EQ(
      why({Beacon{.p = {0, 0, 2}, .normal = {0, 0, 1}}}),
      "eye sees no beacon from any sample: those in its views face away or are out "
      "of range; look at the beacons' normal, emission and range");
  EXPECT_EQ(
      why({Beacon{.p = {0, 0, 2}, .weight = 0}}),
      "eye sees no beacon from any sample: those in its views are hidden, or weigh "
      "nothing");
  EXPECT_EQ(why({Beacon{.p = {0, 0, 2}, .normal = {0, 0, -1}}}), "");
}

TEST(BeaconUse, CountsWhatIsUsed) {
  const auto beacons = plain_cloud(1000, 7);
  const std::vector<TargetPose> poses = {{Eigen::Matrix3d::Identity(), {0, 0, -1}},
                                         {Eigen::Matrix3d::Identity(), {0, 0, 100}}};
  const System system =
      carried_system(PoseState::position, beacons, SightingRule::nearest, 5);
  const BeaconUse use = beacon_use(system, poses);
  EXPECT_EQ(use.sightings, 2.5);  // five at the first, none at the second
  EXPECT_LE(use.beacons, 2.5);
  EXPECT_GT(use.beacons, 0);
  EXPECT_LE(use.views, 1);
}

}  // namespace
}  // namespace delos
