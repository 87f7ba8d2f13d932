// Expected numbers: by hand, from the triangle 3² + 4² = 5².
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "device/devices.h"

namespace delos::test {
namespace {

bool sees(const char* params, double x, double y, double z) {
  Observation out;
  Target target;
  target.p_ST = {x, y, z};
  return device("bearing", params)->observe(target, out);
}

TEST(Bearing, IsTheAngleAboutItsZAxis) {
  Observation out;
  ASSERT_TRUE(device("bearing", "{sigma: 0.02}")->observe(kThirteenAway, out));
  EXPECT_DOUBLE_EQ(out.z(0), std::atan2(4, 3));
  EXPECT_LT((out.H - Eigen::RowVector3d(-4, 3, 0) / 25).norm(), 1e-16);
  EXPECT_DOUBLE_EQ(out.R(0, 0), 0.02 * 0.02);
}

// 12 m up at 5 m away are 67.4 degrees.
TEST(Bearing, SeesWithinItsFieldElevationAndReach) {
  EXPECT_TRUE(sees("{sigma: 0.02, elevation: 1.177}", 3, 4, 12));
  EXPECT_FALSE(sees("{sigma: 0.02, elevation: 1.175}", 3, 4, -12));
  EXPECT_TRUE(sees("{sigma: 0.02, reach: 5}", 3, 4, 0));
  EXPECT_FALSE(sees("{sigma: 0.02, reach: 4.999}", 3, 4, 0));
  EXPECT_FALSE(sees("{sigma: 0.02}", 0, 0, 1));
  // atan(4/3) is 53.13 degrees.
  EXPECT_TRUE(sees("{sigma: 0.02, field: 1.8547}", 3, 4, 0));
  EXPECT_FALSE(sees("{sigma: 0.02, field: 1.8545}", 3, -4, 0));
  EXPECT_TRUE(sees("{sigma: 0.02, field: 4.4287}", -3, 4, 0));
  EXPECT_FALSE(sees("{sigma: 0.02, field: 4.4283}", -3, 4, 0));
  EXPECT_TRUE(sees("{sigma: 0.02}", -3, 0, 0));
}

}  // namespace
}  // namespace delos::test
