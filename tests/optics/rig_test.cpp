// A real calibration of four webcams, as a scene.
#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

// By a script that reads the scene's numbers, projects with OpenCV's formulas, takes
// central differences and inverts Σ HᵀH/σ².
TEST(StereoRig, IsWhatItsCalibrationSays) {
  const Field field = field_of("20-stereo-rig");
  ASSERT_EQ(field.value.size(), 1331u);
  double least = INFINITY, most = 0, sum = 0;
  for (const double value : field.value) {
    least = std::min(least, value);
    most = std::max(most, value);
    sum += value / 1331;
  }
  EXPECT_NEAR(least, 2.0817505e-4, 1e-9);
  EXPECT_NEAR(most, 2.4082124e-4, 1e-9);
  EXPECT_NEAR(sum, 2.3107950e-4, 1e-9);
}

}  // namespace
}  // namespace delos::test
