// Layers: what is recomputed, and that an updated set equals a fresh one bit for bit.
#include "delos/layers/layers.h"

#include <gtest/gtest.h>

#include "support/rigs.h"

namespace delos {
namespace {

using testing::acoustic_system;

/// Twenty range devices about a room; the last ones don't reach everywhere.
System many_devices() {
  System system = acoustic_system();
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 16; ++i) {
    system.devices.push_back(
        testing::place("extra", std::make_shared<testing::TestRange>(0.01, 1.2),
                       {Eigen::Matrix3d::Identity(),
                        {uniform(random), uniform(random), uniform(random)}},
                       50));
  }
  return system;
}

std::vector<TargetPose> grid_poses() {
  return field_poses(testing::volume({0, 0, 0}, {0.4, 0.4, 0.8}, 0.05), {});
}

void expect_same(const InformationLayers& a, const InformationLayers& b) {
  LayerBlock sa, sb;
  ASSERT_EQ(a.block_count(), b.block_count());
  for (std::size_t i = 0; i < a.block_count(); ++i) {
    const LayerBlock& x = a.block(i, sa);
    const LayerBlock& y = b.block(i, sb);
    ASSERT_EQ(x.total, y.total) << "block " << i;
    ASSERT_EQ(x.layers, y.layers) << "block " << i;
    ASSERT_EQ(x.seen, y.seen) << "block " << i;
  }
}

// The two entries of a device, over every state and with markers on lever arms.
TEST(Layers, LanesGiveWhatSinglePointsGive) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] {
    return Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
  };
  std::vector<TargetPose> poses;
  for (int i = 0; i < 150; ++i)
    poses.push_back({rotation_from_rpy(vector()), vector()});
  for (const PoseState state :
       {PoseState::position, PoseState::orientation, PoseState::pose}) {
    const int d = state == PoseState::pose ? 6 : 3;
    System single, lanes;
    single.motion = testing::chain_motion(state, 2, CoordinateMatrix::Identity(d, d));
    single.markers = {{0, 0, 0}, {0.1, -0.2, 0.3}};
    lanes = single;
    for (int i = 0; i < 3; ++i) {
      const double r = i == 2 ? 0 : 0.01, reach = 1.1;  // the last one is perfect
      const Pose X_WS{rotation_from_rpy(vector()), vector()};
      single.devices.push_back(testing::place(
          "s", std::make_shared<testing::TestRange>(r, reach), X_WS, 50));
      lanes.devices.push_back(testing::place(
          "s", std::make_shared<testing::TestFullRange>(r, reach), X_WS, 50));
    }
    const InformationLayers a(single, poses), b(lanes, poses);
    LayerBlock sa, sb;
    int partly = 0;
    for (std::size_t i = 0; i < a.block_count(); ++i) {
      const LayerBlock& x = a.block(i, sa);
      const LayerBlock& y = b.block(i, sb);
      EXPECT_EQ(x.seen, y.seen);
      EXPECT_EQ(x.perfect, y.perfect);
      for (std::size_t e = 0; e < x.total.size(); ++e) {
        EXPECT_NEAR(x.total[e], y.total[e], 1e-11 + 1e-14 * std::abs(x.total[e]));
      }
      partly += x.seen[0] != 0 && ~x.seen[0] != 0;
    }
    EXPECT_GT(partly, 0);
  }
}

TEST(Layers, AMovedDeviceRecomputesOneLayerToTheSameBytes) {
  System system = many_devices();
  InformationLayers layers(system, grid_poses());
  ASSERT_TRUE(layers.kept());
  system.devices[9].X_WS().p.x() += 0.125;
  EXPECT_EQ(layers.update(system), 1u);
  expect_same(layers, InformationLayers(system, grid_poses()));
}

TEST(Layers, MotionMetricAndRateRecomputeNoDevice) {
  System system = many_devices();
  InformationLayers layers(system, grid_poses());
  system.motion =
      testing::chain_motion(PoseState::position, 3, Eigen::Matrix3d::Identity() * 0.1);
  EXPECT_EQ(layers.update(system), 0u);
  system.fusion = Fusion::continuous;
  system.devices[3].period = 0.005;
  EXPECT_EQ(layers.update(system), 0u);
  expect_same(layers, InformationLayers(system, grid_poses()));
}

TEST(Layers, AnAddedDeviceOrMarkerRebuilds) {
  System system = many_devices();
  InformationLayers layers(system, grid_poses());
  system.devices.push_back(system.devices.front());
  EXPECT_EQ(layers.update(system), system.devices.size());
  system.markers.emplace_back(0.1, 0, 0);
  EXPECT_EQ(layers.update(system), system.devices.size());
  expect_same(layers, InformationLayers(system, grid_poses()));
}

TEST(Layers, BeyondTheMemoryLimitTheyAreRecomputedToTheSameBytes) {
  const System system = many_devices();
  const InformationLayers kept(system, grid_poses());
  const InformationLayers recomputed(system, grid_poses(),
                                     {.memory_limit = kept.bytes() - 1});
  EXPECT_TRUE(kept.kept());
  EXPECT_FALSE(recomputed.kept());
  expect_same(kept, recomputed);
}

// 20 devices, 3 groups and a total of 6 numbers over 64 lanes, and two words a device.
TEST(Layers, StateTheirMemory) {
  const System system = many_devices();
  const std::vector<TargetPose> poses(64 * 3 + 1);
  const InformationLayers layers(system, poses, {.memory_limit = 0});
  EXPECT_EQ(layers.block_count(), 4u);
  EXPECT_EQ(layers.bytes(), 4u * ((20 + 3 + 1) * 6 * 64 * 8 + 2 * 20 * 8));
}

TEST(Layers, WhitenedRowsSquareToTheInformation) {
  const System system = many_devices();
  const TargetPose pose{Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.3}};
  const WhitenedRows w = whitened_rows(system, pose);
  const Eigen::Matrix3d S = w.rows.transpose() * w.rows;
  LayerBlock scratch;
  const InformationLayers layers(system, {pose});
  const LayerBlock& block = layers.block(0, scratch);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) {
      EXPECT_NEAR(block.total[static_cast<std::size_t>(packed_index(i, j) * kLanes)],
                  S(i, j), 1e-12 * S.norm());
    }
  }
}

// A marker on an arm turns with the target: δz = H (δp + δθ × R m). By differences of
// the range itself.
TEST(Layers, LeverArmsGiveTheJacobianOfOrientation) {
  System system;
  system.motion =
      testing::chain_motion(PoseState::pose, 1, CoordinateMatrix::Identity(6, 6));
  system.markers = {{0.3, -0.1, 0.2}};
  const Pose X_WS{rotation_from_rpy({0.3, -0.2, 0.5}), {1, 2, 3}};
  system.devices = {
      testing::place("r", std::make_shared<testing::TestRange>(0.005), X_WS, 50)};
  const TargetPose pose{rotation_from_rpy({0.4, 0.1, -0.7}), {0.2, 0.1, -0.3}};
  const auto range = [&](const Eigen::Vector3d& dp, const Eigen::Vector3d& dtheta) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(dtheta.norm(), dtheta.norm() > 0 ? dtheta.normalized()
                                                           : Eigen::Vector3d::UnitX())
            .toRotationMatrix();
    return (pose.p + dp + turn * pose.R * system.markers[0].p - X_WS.p).norm();
  };
  const double h = 1e-5, z = range({0, 0, 0}, {0, 0, 0});
  const WhitenedRows w = whitened_rows(system, pose);
  ASSERT_EQ(w.rows.rows(), 1);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(axis), none(0, 0, 0);
    const double scale = 1 / std::sqrt(0.005 * z * z);
    EXPECT_NEAR(w.rows(0, axis),
                scale * (range(step, none) - range(-step, none)) / (2 * h), 1e-7);
    EXPECT_NEAR(w.rows(0, 3 + axis),
                scale * (range(none, step) - range(none, -step)) / (2 * h), 1e-7);
  }
}

// The prior stands in the total alone, as S = prior·1 + Σ S_i.
TEST(Layers, APriorRecomputesNoDevice) {
  System system = many_devices();
  InformationLayers layers(system, grid_poses());
  LayerBlock scratch;
  const LayerBlock without = layers.block(1, scratch);
  system.prior = 0.25;
  EXPECT_EQ(layers.update(system), 0u);
  expect_same(layers, InformationLayers(system, grid_poses()));
  const LayerBlock& with = layers.block(1, scratch);
  EXPECT_EQ(with.layers, without.layers);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) {
      const auto e = static_cast<std::size_t>(packed_index(i, j) * kLanes + 5);
      EXPECT_NEAR(with.total[e] - without.total[e], i == j ? 0.25 : 0,
                  1e-12 * std::abs(without.total[e]));
    }
  }
}

// A device that fails leaves the layers of a system that never had it.
TEST(Layers, WithoutADeviceAreThoseOfTheOthers) {
  const System system = many_devices();
  const InformationLayers kept(system, grid_poses()),
      made(system, grid_poses(), {.memory_limit = 0});
  for (const std::size_t device : {0u, 7u, 8u, 19u}) {
    System rest = system;
    rest.devices.erase(rest.devices.begin() + device);
    const InformationLayers fresh(rest, grid_poses());
    expect_same(kept.without(device), fresh);
    expect_same(made.without(device), fresh);
    EXPECT_EQ(kept.without(device).system().devices.size(), 19u);
  }
}

}  // namespace
}  // namespace delos
