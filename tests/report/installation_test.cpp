// What an installer reads, set again, is the design.
#include "report/installation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

namespace delos::report {
namespace {

/// A device that looks along x with its x axis level is rolled, tilted, then panned.
Eigen::Matrix3d set_by(const Facing& f) {
  Eigen::Matrix3d level;  // columns: right, down and ahead
  level << 0, 0, 1,       //
      -1, 0, 0,           //
      0, -1, 0;
  using Eigen::AngleAxisd;
  return (AngleAxisd(f.pan, Eigen::Vector3d::UnitZ()) *
          AngleAxisd(-f.tilt, Eigen::Vector3d::UnitY()))
             .toRotationMatrix() *
         level * AngleAxisd(f.roll, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

TEST(Installation, SetsEveryOrientationAgain) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Quaterniond q = Eigen::Quaterniond(normal(random), normal(random),
                                                    normal(random), normal(random))
                                     .normalized();
    const Eigen::Matrix3d R = q.toRotationMatrix();
    EXPECT_TRUE(set_by(facing_of(R)).isApprox(R, 1e-9));
  }
  // Straight down: the image's upper edge is where the pan says.
  const Facing down = facing_of(set_by({0.7, -std::numbers::pi / 2, 0}));
  EXPECT_NEAR(down.pan, 0.7, 1e-9);
  EXPECT_EQ(down.roll, 0);
  EXPECT_NEAR(down.tilt, -std::numbers::pi / 2, 1e-9);
}

// By hand: it looks along y, down by 30 degrees, its right side level.
TEST(Installation, SaysAnglesAsPeopleDo) {
  Eigen::Matrix3d R;
  const double c = std::cos(std::numbers::pi / 6), s = 0.5;
  R.col(0) = Eigen::Vector3d(1, 0, 0);
  R.col(1) = Eigen::Vector3d(0, -s, -c);
  R.col(2) = Eigen::Vector3d(0, c, -s);
  const Facing f = facing_of(R);
  EXPECT_NEAR(f.pan, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(f.tilt, -std::numbers::pi / 6, 1e-12);
  EXPECT_NEAR(f.roll, 0, 1e-12);
}

/// A room of 6 m by 5 m by 3 m whose corner is at (−1, 2, 0.5), as walls.
Scene room() {
  OccluderEntry walls;
  walls.name = "hall";
  walls.room = true;
  walls.body = BoxShape{{-3, 0, 0}, {3, 5, 3}};
  walls.placement.at = {2, 2, 0.5};
  Scene scene;
  scene.occluders.push_back(walls);
  return scene;
}

// By hand, for every wall.
TEST(Installation, MeasuresFromTheNearerWallAndTheFloor) {
  const auto walls = walls_of(room());
  ASSERT_TRUE(walls.has_value());
  EXPECT_TRUE(walls->min().isApprox(Eigen::Vector3d(-1, 2, 0.5), 1e-12));
  EXPECT_TRUE(walls->max().isApprox(Eigen::Vector3d(5, 7, 3.5), 1e-12));
  struct Row {
    Eigen::Vector3d at;
    const char *across, *along;
    double x, y, up;
  };
  const Row rows[] = {{{-0.6, 6.9, 3.2}, "left", "back", 0.4, 0.1, 2.7},
                      {{4.75, 2.3, 0.5}, "right", "front", 0.25, 0.3, 0},
                      // Beyond a wall, and in the very middle, where the first counts.
                      {{5.2, 4.5, 4}, "right", "front", -0.2, 2.5, 3.5}};
  for (const Row& row : rows) {
    const std::vector<FromWall> from = from_walls(row.at, *walls);
    ASSERT_EQ(from.size(), 3u);
    EXPECT_EQ(from[0].wall, row.across);
    EXPECT_NEAR(from[0].distance, row.x, 1e-12);
    EXPECT_EQ(from[1].wall, row.along);
    EXPECT_NEAR(from[1].distance, row.y, 1e-12);
    EXPECT_EQ(from[2].wall, "floor");
    EXPECT_NEAR(from[2].distance, row.up, 1e-12);
  }
}

TEST(Installation, HasNoWallsWhereThereIsNoRoom) {
  Scene scene = room();
  scene.occluders.front().room = false;
  EXPECT_FALSE(walls_of(scene).has_value());
  scene.occluders.front() = room().occluders.front();
  scene.occluders.front().mount = Mount::target;
  EXPECT_FALSE(walls_of(scene).has_value());
}

}  // namespace
}  // namespace delos::report
