#include "delos/model/pose.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "delos/scene/scene.h"

namespace delos {
namespace {

using std::numbers::pi;

Eigen::Vector3d random_vector(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-3, 3);
  return {uniform(random), uniform(random), uniform(random)};
}

TEST(RotationFromRpy, TurnsAboutXThenYThenZ) {
  // Quarter turns by hand: roll takes y to z, pitch takes z to x, yaw takes x to y.
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  EXPECT_TRUE((rotation_from_rpy({pi / 2, 0, 0}) * y).isApprox(z, 1e-15));
  EXPECT_TRUE((rotation_from_rpy({0, pi / 2, 0}) * z).isApprox(x, 1e-15));
  EXPECT_TRUE((rotation_from_rpy({0, 0, pi / 2}) * x).isApprox(y, 1e-15));
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d a = random_vector(random);
    const Eigen::Matrix3d R =
        (Eigen::AngleAxisd(a.z(), z) * Eigen::AngleAxisd(a.y(), y) *
         Eigen::AngleAxisd(a.x(), x))
            .toRotationMatrix();
    EXPECT_LT((rotation_from_rpy(a) - R).norm(), 1e-14);
  }
}

TEST(RotationFromAim, LooksAlongZWithXToTheRight) {
  // Looking along the world's y with z up: right is x, down is −z.
  Eigen::Matrix3d R;
  R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  EXPECT_TRUE(rotation_from_aim({5, 5, 5}, {5, 9, 5}).isApprox(R, 1e-15));
}

TEST(RotationFromAim, IsARotationWithALevelXAxis) {
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d from = random_vector(random), to = random_vector(random);
    const Eigen::Matrix3d R = rotation_from_aim(from, to);
    EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(R.determinant(), 1, 1e-14);
    EXPECT_LT((R.col(2) - (to - from).normalized()).norm(), 1e-15);
    EXPECT_NEAR(R(2, 0), 0, 1e-15);  // right is level
    EXPECT_LE(R(2, 1), 0);           // down isn't up
  }
}

TEST(RotationFromAim, KeepsXWhereItLooksStraightUpOrDown) {
  for (const double z : {1.0, -1.0}) {
    const Eigen::Matrix3d R = rotation_from_aim({1, 2, 3}, {1, 2, 3 + z});
    EXPECT_EQ(R.col(0), Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(R.col(1), Eigen::Vector3d(0, z, 0));
    EXPECT_EQ(R.col(2), Eigen::Vector3d(0, 0, z));
  }
  // All but vertical: still a rotation.
  const Eigen::Matrix3d R = rotation_from_aim({0, 0, 0}, {1e-11, 1e-11, 1});
  EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

TEST(PoseOf, NormalisesQuaternions) {
  Placement placement;
  placement.at = {1, 2, 3};
  placement.facing = QuaternionWxyz{{2, 0, 0, 2}};  // a quarter turn about z
  const Pose X = pose_of(placement);
  EXPECT_EQ(X.p, Eigen::Vector3d(1, 2, 3));
  EXPECT_LT((X.R - rotation_from_rpy({0, 0, pi / 2})).norm(), 1e-15);
  placement.facing = QuaternionWxyz{{1e-200, 0, 0, 1e-200}};
  EXPECT_LT((pose_of(placement).R - X.R).norm(), 1e-15);
}

TEST(PoseOf, AimsFromItsOwnPlace) {
  Placement placement;
  placement.at = {0, 0, 1};
  placement.facing = Aim{{0, 4, 1}};
  EXPECT_LT((pose_of(placement).R.col(2) - Eigen::Vector3d(0, 1, 0)).norm(), 1e-15);
  placement.facing = std::monostate{};
  EXPECT_EQ(pose_of(placement).R, Eigen::Matrix3d::Identity());
}

TEST(DevicePose, IsRelativeToTheGroup) {
  Scene scene;
  Group group;
  group.name = "rig";
  group.placement.at = {10, 0, 0};
  group.placement.facing = Rpy{{0, 0, pi / 2}};
  scene.groups = {Group{"other", {}}, group};
  DeviceEntry device;
  device.placement.at = {1, 0, 0};
  EXPECT_EQ(device_pose(scene, device).p, Eigen::Vector3d(1, 0, 0));
  device.group = "rig";  // its x axis is the world's y
  EXPECT_LT((device_pose(scene, device).p - Eigen::Vector3d(10, 1, 0)).norm(), 1e-15);
  EXPECT_LT((device_pose(scene, device).R - rotation_from_rpy({0, 0, pi / 2})).norm(),
            1e-15);
}

TEST(Words, AreThoseOfScenes) {
  EXPECT_STREQ(to_string(Fusion::stacked), "stacked");
  EXPECT_STREQ(to_string(Fusion::artemis), "artemis");
  EXPECT_STREQ(to_string(CovarianceKind::posterior), "posterior");
}

}  // namespace
}  // namespace delos
