// Expected numbers: by hand, from the quadruple 3² + 4² + 12² = 13².
#include <gtest/gtest.h>

#include <cmath>

#include "device/devices.h"

namespace delos::test {
namespace {

TEST(AcousticRange, MeasuresDistanceWithThePapersNoise) {
  Observation out;
  ASSERT_TRUE(device("acoustic_range", "{}")->observe(kThirteenAway, out));
  EXPECT_DOUBLE_EQ(out.z(0), 13);
  EXPECT_LT((out.H - Eigen::RowVector3d(3, 4, 12) / 13).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(out.R(0, 0), 0.845);  // 0.005 · 169
}

TEST(AcousticRange, MayBePerfect) {
  Observation out;
  ASSERT_TRUE(device("acoustic_range", "{r: 0}")->observe(kThirteenAway, out));
  EXPECT_EQ(out.R(0, 0), 0);
}

TEST(AcousticRange, HasNoDirectionAtItsPlace) {
  Observation out;
  EXPECT_FALSE(device("acoustic_range", "{}")->observe(Target{}, out));
}

TEST(AcousticRange, ReachesJustSoFar) {
  Observation out;
  EXPECT_TRUE(device("acoustic_range", "{reach: 13}")->observe(kThirteenAway, out));
  EXPECT_FALSE(device("acoustic_range", "{reach: 12.999999999999996}")
                   ->observe(kThirteenAway, out));
}

}  // namespace
}  // namespace delos::test
