// What an installer reads, set again, is the design.
#include "report/installers_sheet.h"

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

TEST(InstallersSheet, SetsEveryOrientationAgain) {
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
TEST(InstallersSheet, SaysAnglesAsPeopleDo) {
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

}  // namespace
}  // namespace delos::report
