// Devices by formulas against the same in C++: other plugins, and derivatives by hand.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "delos/device/faults.h"
#include "device/devices.h"

namespace delos::test {
namespace {

Target turned_target() {
  Target target;
  target.p_ST = {0.3, -0.4, 2};
  target.R_ST = Eigen::Quaterniond(0.9, 0.1, -0.3, 0.2).normalized().toRotationMatrix();
  return target;
}

void expect_same(const Device& a, const Device& b, const Target& at) {
  Observation of_a, of_b;
  ASSERT_TRUE(a.observe(at, of_a));
  ASSERT_TRUE(b.observe(at, of_b));
  ASSERT_EQ(of_a.H.rows(), of_b.H.rows());
  EXPECT_LT((of_a.z - of_b.z).norm(), 1e-14 * of_b.z.norm());
  EXPECT_LT((of_a.H - of_b.H).norm(), 1e-14 * of_b.H.norm());
  EXPECT_LT((of_a.R - of_b.R).norm(), 1e-14 * of_b.R.norm());
}

TEST(Custom, IsWhatOtherPluginsAre) {
  const Target at = turned_target();
  expect_same(*device("custom",
                      "{reading: \"sqrt((x-p1)^2 + y^2 + z^2)\", p: [0], "
                      "sigma: \"0.05 + 0.01*sqrt(x^2+y^2+z^2)\"}"),
              *device("range", "{noise: expression, expression: \"0.05 + 0.01*d\"}"),
              at);
  expect_same(*device("custom", "{reading: \"atan2(y, x)\", sigma: \"0.02\"}"),
              *device("bearing", "{sigma: 0.02}"), kThirteenAway);
  expect_same(
      *device("custom", "{reading: \"x/z; y/z\", sigma: \"0.001\", inside: \"z\"}"),
      *device("pinhole_camera",
              "{focal: 0.006, pitch: 6e-6, resolution: [2000, 2000], sigma: 1}"),
      at);
}

TEST(Custom, GoesOnSmoothlyAsOtherPluginsDo) {
  const auto custom = device("custom",
                             "{reading: \"sqrt(x^2+y^2+z^2)\", sigma: \"0.1\", "
                             "beyond: smooth, inside: \"30 - sqrt(x^2+y^2+z^2)\"}"),
             range = device("range", "{sigma: 0.1, reach: 30}");
  SmoothRows a, b;
  for (const double scale : {1.0, 3.0}) {
    const Eigen::Vector3d p = scale * kThirteenAway.p_ST;
    ASSERT_TRUE(custom->observe_smoothly(p, a));
    ASSERT_TRUE(range->observe_smoothly(p, b));
    EXPECT_NEAR(a.margin, b.margin, 1e-14);
    EXPECT_LT((a.margin_slope - b.margin_slope).norm(), 1e-14);
    for (int k = 0; k < 3; ++k)
      EXPECT_LT((a.H_slope[k].row(0) - b.H_slope[k].row(0)).norm(), 1e-15);
  }
}

// R[y, x] is entry (1, 0); where the target turns by δθ its column x moves by δθ × it.
TEST(Custom, ReadsTheOrientation) {
  const auto compass = device("custom", "{reading: \"R[y, x] + 2*z\", sigma: \"0.1\"}");
  EXPECT_EQ(compass->span(), Span::pose);
  const Target at = turned_target();
  Observation out;
  ASSERT_TRUE(compass->observe(at, out));
  EXPECT_DOUBLE_EQ(out.z(0), at.R_ST(1, 0) + 4);
  Eigen::Matrix<double, 1, 6> expected;
  expected << 0, 0, 2, -at.R_ST(2, 0), 0, at.R_ST(0, 0);
  EXPECT_LT((out.H - expected).norm(), 1e-16);
}

TEST(Custom, SaysWhichReadingsComeBackToThemselves) {
  const auto both = device(
      "custom", "{reading: \"atan2(y, x); z\", sigma: \"0.1\", period: \"2*pi; 0\"}");
  EXPECT_EQ(both->period(0), 2 * std::acos(-1));
  EXPECT_EQ(both->period(1), 0);
  const auto one =
      device("custom", "{reading: \"x; y\", sigma: \"0.1\", period: \"360\"}");
  EXPECT_EQ(one->period(1), 360);
  EXPECT_EQ(device("custom", "{reading: \"x\", sigma: \"0.1\"}")->period(0), 0);
}

TEST(Custom, DoesNotSeeWhereAFormulaHasNoValue) {
  const auto log = device("custom", "{reading: \"log(x)\", sigma: \"0.1\"}");
  Observation out;
  Target target;
  target.p_ST = {-1, 0, 0};
  EXPECT_FALSE(log->observe(target, out));
  target.p_ST = {1, 0, 0};
  EXPECT_TRUE(log->observe(target, out));
}

TEST(Custom, SaysWhichFormulaIsWrongAndWhere) {
  const auto wrong = [](const std::string& params) {
    try {
      (void)device("custom", params);
    } catch (const Unbuildable& refusal) {
      return refusal.parameter() + " " + std::to_string(refusal.character()) + ": " +
             refusal.what();
    }
    return std::string("accepted");
  };
  EXPECT_EQ(wrong("{reading: \"x; y + p2\", sigma: \"1\", p: [3]}"),
            "reading 7: 'p2' isn't known here; did you mean 'p1'?; there are x, y, z, "
            "p1, and R[row, column] of x, y, z");
  EXPECT_EQ(wrong("{reading: \"x\", sigma: \"1 +\"}"),
            "sigma 3: expected a number, a name or '(', found the end");
  EXPECT_EQ(wrong("{reading: \"x; y\", sigma: \"1; 2; 3\"}"),
            "sigma 0: has 3 formulas; give one, or one a reading, which are 2");
  EXPECT_EQ(wrong("{reading: \"x\", sigma: \"1\", inside: \"x; y\"}"),
            "inside 0: must be one formula");
  EXPECT_EQ(wrong("{reading: \"x\", sigma: \"1\", period: \"-1\"}"),
            "period 0: must be 0 or more");
  EXPECT_EQ(wrong("{reading: \"x\", sigma: \"1\", period: \"1; 2\"}"),
            "period 0: has 2 formulas; give one, or one a reading, which are 1");
  EXPECT_EQ(wrong("{reading: \"1;1;1;1;1;1;1;1;1;1\", sigma: \"1\"}"),
            "reading 18: has more than 9 formulas");
}

}  // namespace
}  // namespace delos::test
