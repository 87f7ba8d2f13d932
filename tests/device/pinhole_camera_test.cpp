#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "device/devices.h"

namespace delos::test {
namespace {

bool sees(const Device& camera, double x, double y, double z) {
  Observation out;
  return camera.observe(Target{.p_ST = {x, y, z}, .state = {}}, out);
}

/// Degrees between the outermost directions seen along an image axis.
double field_of_view(const Device& camera, const Eigen::Vector2d& axis) {
  double seen = 0, unseen = std::numbers::pi / 2;
  while (unseen - seen > 1e-9) {
    const double angle = (seen + unseen) / 2;
    const Eigen::Vector2d side = std::tan(angle) * axis;
    (sees(camera, side.x(), side.y(), 1) ? seen : unseen) = angle;
  }
  return 2 * seen * 180 / std::numbers::pi;
}

// Point Grey Dragonfly: 6 mm lens, 640 × 480 pixels of 7.4 µm, so f = 810.8 px. Its
// field of view is quoted as 43.07° × 32.97°, cut off at two digits: 2 atan(640 / (2 ·
// 810.8)) is 43.075°, 2 atan(480 / (2 · 810.8)) is 32.978°.
const char* const kDragonfly = "{focal: 0.006, pitch: 7.4e-6, resolution: [640, 480]}";

TEST(PinholeCamera, HasTheFieldOfViewOfTheDataSheet) {
  const auto camera = device("pinhole_camera", kDragonfly);
  EXPECT_NEAR(field_of_view(*camera, {1, 0}), 43.075, 0.001);
  EXPECT_NEAR(field_of_view(*camera, {-1, 0}), 43.075, 0.001);
  EXPECT_NEAR(field_of_view(*camera, {0, 1}), 32.978, 0.001);
  EXPECT_NEAR(field_of_view(*camera, {0, -1}), 32.978, 0.001);
}

// Of a camera's Jacobian, ∂(pixels)/∂p, the two singular values other than 0 say how
// many pixels a metre across the sight line covers, in two directions; the footprint is
// the length of the one that gets fewer.
TEST(PinholeCamera, HasTheFootprintOfItsJacobian) {
  const auto camera = device("pinhole_camera", kDragonfly);
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(0, 0, 2), {0.4, -0.2, 2}, {-1.1, 0.8, 3}, {0.01, 0, 0.3}}) {
    Observation out;
    ASSERT_TRUE(camera->observe(Target{.p_ST = p, .state = {}}, out));
    const Eigen::MatrixXd in_pixels = out.H * (0.006 / 7.4e-6);
    const double fewest = in_pixels.jacobiSvd().singularValues()(1);
    EXPECT_NEAR(camera->footprint(p), 1 / fewest, 1e-12 / fewest);
  }
  // 7.4 µm at 6 mm, two metres away: 2.47 mm.
  EXPECT_NEAR(camera->footprint({0, 0, 2}), 2 * 7.4e-6 / 0.006, 1e-18);
}

// Powers of two, in which the half image is exactly 1 wide and ½ high:
// 1024 · 2⁻¹⁷ / (2 · 2⁻⁸) = 1, and half of that for 512 rows.
TEST(PinholeCamera, FrustumIsExactAtItsEdges) {
  const auto camera =
      device("pinhole_camera",
             "{focal: 0.00390625, pitch: 7.62939453125e-06, resolution: [1024, 512], "
             "near: 0.25, far: 8}");
  const auto above = [](double x) { return std::nextafter(x, 2 * x); };
  const auto below = [](double x) { return std::nextafter(x, 0); };
  EXPECT_TRUE(sees(*camera, 2, 1, 2));
  EXPECT_TRUE(sees(*camera, -2, -1, 2));
  EXPECT_FALSE(sees(*camera, above(2), 1, 2));
  EXPECT_FALSE(sees(*camera, above(-2), 1, 2));
  EXPECT_FALSE(sees(*camera, 2, above(1), 2));
  EXPECT_FALSE(sees(*camera, 2, above(-1), 2));
  EXPECT_TRUE(sees(*camera, 0, 0, 0.25));
  EXPECT_FALSE(sees(*camera, 0, 0, below(0.25)));
  EXPECT_TRUE(sees(*camera, 0, 0, 8));
  EXPECT_FALSE(sees(*camera, 0, 0, above(8)));
  EXPECT_FALSE(sees(*camera, 0, 0, -1));
  EXPECT_FALSE(sees(*camera, 0, 0, 0));
}

// By hand: u = 2/6, v = 3/6; d² = 2² + 3² + 6² = 49.
TEST(PinholeCamera, NoiseGrowsWithTheSquareOfDistance) {
  const auto camera =
      device("pinhole_camera",
             "{focal: 0.004, pitch: 1e-5, resolution: [1000, 1000], noise: distance, "
             "r: 4e-6, sigma: 100}");
  Observation out;
  ASSERT_TRUE(camera->observe(Target{.p_ST = {2, 3, 6}, .state = {}}, out));
  EXPECT_DOUBLE_EQ(out.z(0), 1.0 / 3);
  EXPECT_DOUBLE_EQ(out.z(1), 0.5);
  EXPECT_LT((out.R - 1.96e-4 * Eigen::Matrix2d::Identity()).norm(), 1e-18);
}

// By hand: a tenth of a pixel is 0.1 · 7.4e-6 / 0.006 = 1.23333…e-4 of a slope.
TEST(PinholeCamera, NoiseInPixelsIsTheSameAnywhere) {
  const auto camera = device(
      "pinhole_camera", "{focal: 0.006, pitch: 7.4e-6, resolution: [640, 480], r: 9}");
  for (const double depth : {0.1, 1.0, 50.0}) {
    Observation out;
    ASSERT_TRUE(camera->observe(Target{.p_ST = {0, 0, depth}, .state = {}}, out));
    EXPECT_LT((out.R - 1.52111111111e-8 * Eigen::Matrix2d::Identity()).norm(), 1e-18);
  }
}

TEST(PinholeCamera, RefusesParametersThatClash) {
  EXPECT_EQ(
      refusal("pinhole_camera",
              "{focal: 0.006, pitch: 7.4e-6, resolution: [640, 480], near: 2, far: 2}"),
      "near must be less than far");
  EXPECT_EQ(
      refusal("pinhole_camera", "{focal: 0.006, pitch: 7.4e-6, resolution: [640, 0]}"),
      "resolution must be a width and a height above 0");
  EXPECT_EQ(
      refusal("pinhole_camera", "{focal: 0.006, pitch: 7.4e-6, resolution: [640]}"),
      "resolution must be a width and a height above 0");
}

}  // namespace
}  // namespace delos::test
