// What a pixel covers at a sample, of the device that does best among those that see
// it.
#include <gtest/gtest.h>

#include "support/rigs.h"

namespace delos {
namespace {

/// Sees what is before it up to `reach`, with pixels of `part` of the depth.
class PixelCamera final : public testing::TestRange {
 public:
  PixelCamera(double part, double reach) : TestRange(0.01, reach), part_(part) {}
  double footprint(const Eigen::Vector3d& p) const override { return part_ * p.z(); }

 private:
  double part_;
};

System pixel_rig() {
  System system = testing::acoustic_system();
  system.devices.resize(1);  // without pixels, and sees everything
  const Eigen::Matrix3d down = Eigen::Vector3d(1, -1, -1).asDiagonal();
  system.devices.push_back(testing::place(
      "near", std::make_shared<PixelCamera>(0.001, 2.5), {down, {0, 0, 3}}, 50));
  system.devices.push_back(testing::place(
      "far", std::make_shared<PixelCamera>(0.0005, 9), {down, {0, 0, 6}}, 50));
  return system;
}

TEST(Footprint, IsThatOfTheBestDeviceThatSeesTheSample) {
  const System system = pixel_rig();
  const Metric metric = testing::metric_of(system, "footprint");
  EXPECT_EQ(metric.unit, "m");
  EXPECT_FALSE(metric.larger_is_better);
  // 1 mm per metre of 3 − z against 0.5 mm of 6 − z: equal at z = 0, where the near one
  // doesn't reach.
  const Samples samples =
      testing::points({{0, 0, 2}, {0, 0, 1}, {0, 0, 0}, {0, 0, -2}, {20, 0, 0}});
  for (const Fusion fusion : {Fusion::stacked, Fusion::sequential}) {
    System of_fusion = system;
    of_fusion.fusion = fusion;
    const Field field = evaluate_field(of_fusion, samples, {}, metric);
    EXPECT_NEAR(field.value[0], 0.001, 1e-15);
    EXPECT_NEAR(field.value[1], 0.002, 1e-15);
    EXPECT_NEAR(field.value[2], 0.003, 1e-15);
    EXPECT_NEAR(field.value[3], 0.004, 1e-15);
    EXPECT_TRUE(std::isinf(field.value[4]));
  }
}

}  // namespace
}  // namespace delos
