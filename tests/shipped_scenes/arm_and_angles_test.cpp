// Scenes of a jointed arm, and of depth beside angles, against equations of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

// trace J Jᵀ of tip(a, s, e) is ρ² + r² + l₂²: the waist moves it by ρ, the shoulder by r,
// the elbow by l₂.
TEST(JointedArm, KnowsItsTipAsItsForwardEquationsSay) {
  const Field field = field_of("28-jointed-arm");
  const double sigma = 2 * std::numbers::pi / 4096 / std::sqrt(12.0);
  int reached = 0;
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    if (!std::isfinite(field.value[i])) continue;
    ++reached;
    const Eigen::Vector3d p = field.samples.points[i] - Eigen::Vector3d(0, 0, 0.8);
    const double rho = std::hypot(p.x(), p.y());
    ASSERT_NEAR(field.value[i],
                sigma * std::sqrt(rho * rho + p.squaredNorm() + 0.35 * 0.35), 1e-12);
  }
  EXPECT_EQ(reached, 1684);
}

// By a script of the two devices' equations that knows nothing of Delos.
TEST(DepthAndAngles, KnowMoreTogether) {
  const auto expect = [](const Field& field, double least, double mean, double most) {
    double low = INFINITY, high = 0, sum = 0;
    int count = 0;
    for (const double v : field.value) {
      if (!std::isfinite(v)) continue;
      low = std::min(low, v);
      high = std::max(high, v);
      sum += v;
      ++count;
    }
    EXPECT_EQ(count, 671);
    EXPECT_NEAR(low, least, 1e-9);
    EXPECT_NEAR(sum / count, mean, 1e-9);
    EXPECT_NEAR(high, most, 1e-9);
  };
  const Scene both = load("29-depth-and-angles");
  expect(field_of(both), 0.5704338143691767e-3, 4.543837273433472e-3,
         9.07838155427615e-3);
  Scene depth = both;
  depth.devices.resize(1);
  expect(field_of(depth), 17.08512822366376e-3, 19.08032312392671e-3,
         23.27788552728704e-3);
}

}  // namespace
}  // namespace delos::test
