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

// Of a surface that leans by α from the sight line a pixel covers 1/cos α as much; its
// other side is seen alike.
TEST(Footprint, OnASurfaceIsAlongIt) {
  const System system = pixel_rig();
  const Metric metric = testing::metric_of(system, "footprint");
  // Planes through (0, 0, 2), 1 m below the near camera, whose sight lines end in the
  // plane x = 0 or y = 0; samples at the corners of the plane.
  const auto of = [&](const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    const Samples samples =
        make_samples({{"", PlaneSampling{{0, 0, 2}, u, v, {2, 2}}}});
    return evaluate_field(system, samples, {}, metric).value[0];
  };
  EXPECT_NEAR(of({1, 0, 0}, {0, 1, 0}), 0.001, 1e-15);
  EXPECT_NEAR(of({0, 1, 0}, {1, 0, 0}), 0.001, 1e-15);
  EXPECT_NEAR(of({1, 0, 1}, {0, 1, 0}), 0.001 * std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(of({1, 0, 0}, {0, 1, std::sqrt(3.0)}), 0.002, 1e-15);
  EXPECT_GT(of({1, 0, 0}, {0, 0, 1}), 1e9);  // edge on
}

// The same of a mesh, at a vertex by the mean of its triangles.
TEST(Footprint, OnAMeshIsThatOfItsVertices) {
  System system = pixel_rig();
  system.devices.resize(2);  // the near one
  const Metric metric = testing::metric_of(system, "footprint");
  Samples roof = testing::points({{0, 0, 2}, {0, 1, 2}, {1, 0, 1}, {1, 1, 1}});
  roof.parts[0].shape = SurfaceShape{{{0, 2, 1}, {1, 2, 3}}};
  const Field field = evaluate_field(system, roof, {}, metric);
  // n = (1, 0, 1)/√2 everywhere; the sight line to a corner is (x, y, z − 3).
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d line = roof.points[i] - Eigen::Vector3d(0, 0, 3);
    const double facing =
        std::abs(line.normalized().dot(Eigen::Vector3d(1, 0, 1).normalized()));
    EXPECT_NEAR(field.value[i], 0.001 * -line.z() / facing, 1e-15) << i;
  }
}

}  // namespace
}  // namespace delos
