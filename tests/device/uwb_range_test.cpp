// Expected numbers: by hand, from the quadruple 3² + 4² + 12² = 13².
#include <gtest/gtest.h>

#include "device/devices.h"

namespace delos::test {
namespace {

TEST(UwbRange, MeasuresDistanceWithConstantNoise) {
  Observation out;
  ASSERT_TRUE(device("uwb_range", "{}")->observe(kThirteenAway, out));
  EXPECT_DOUBLE_EQ(out.z(0), 13);
  EXPECT_LT((out.H - Eigen::RowVector3d(3, 4, 12) / 13).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(out.R(0, 0), 0.01);  // (0.1 m)²
}

TEST(UwbRange, MayFadeWithRange) {
  Observation out;
  ASSERT_TRUE(
      device("uwb_range", "{sigma: 0.05, growth: 0.01}")->observe(kThirteenAway, out));
  EXPECT_DOUBLE_EQ(out.R(0, 0), 0.0194);  // 0.05² + 0.13²
}

TEST(UwbRange, HasNoDirectionAtItsPlace) {
  Observation out;
  EXPECT_FALSE(device("uwb_range", "{}")->observe(Target{}, out));
}

TEST(UwbRange, ReachesJustSoFarAndNeedsSight) {
  Observation out;
  EXPECT_TRUE(device("uwb_range", "{reach: 13}")->observe(kThirteenAway, out));
  EXPECT_FALSE(
      device("uwb_range", "{reach: 12.999999999999996}")->observe(kThirteenAway, out));
  EXPECT_TRUE(device("uwb_range", "{}")->needs_sight());
}

}  // namespace
}  // namespace delos::test
