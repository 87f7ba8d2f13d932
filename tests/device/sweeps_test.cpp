// Devices that measure angles: base stations and goniometers.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "device/devices.h"
#include "device/look.h"

namespace delos::test {
namespace {

// How crazyflie-firmware converts angles (docs/functional-areas/lighthouse/
// angle_conversion.md), with the rotor's axis down and t = 30 degrees:
// α₂ = α_h ± asin(q tan t), q = tan α_v/√(1 + tan²α_h).
TEST(Lighthouse, SecondGenerationSweepsTiltedPlanes) {
  const auto first = device("lighthouse", "{generation: v1}"),
             second = device("lighthouse", "{generation: v2}");
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(0, 0, 1), {1, 0.4, 2}, {-1.5, -1, 1.2}, {0.2, 1.3, 1}}) {
    const auto a = look(*first, p), b = look(*second, p);
    ASSERT_TRUE(a && b);
    const double h = std::tan(a->z(0)), v = std::tan(a->z(1));
    const double lean =
        std::asin(v / std::sqrt(1 + h * h) * std::tan(std::numbers::pi / 6));
    EXPECT_NEAR(b->z(0), a->z(0) + lean, 1e-12);
    EXPECT_NEAR(b->z(1), a->z(0) - lean, 1e-12);
  }
}

// A quarter of a sweep's variance is a photodiode's own.
TEST(Lighthouse, SaysWhatPhotodiodesShare) {
  const auto station = device("lighthouse", "{sigma: 4e-5, common: 0.75}");
  EXPECT_NEAR(station->shared_variance()(0), 0.75 * 16e-10, 1e-24);
  EXPECT_NEAR(look(*station, {0, 0, 2})->R(1, 1), 16e-10, 1e-24);
}

TEST(Lighthouse, SweepsAsFarAsItSays) {
  const auto station = device("lighthouse", "{across: 2, down: 1, reach: 5}");
  EXPECT_TRUE(look(*station, {std::sin(0.999), 0, std::cos(0.999)}));
  EXPECT_FALSE(look(*station, {std::sin(1.001), 0, std::cos(1.001)}));
  EXPECT_TRUE(look(*station, {0, std::sin(0.499), std::cos(0.499)}));
  EXPECT_FALSE(look(*station, {0, std::sin(-0.501), std::cos(0.501)}));
  EXPECT_TRUE(look(*station, {0, 0, 4.99}));
  EXPECT_FALSE(look(*station, {0, 0, 5.01}));
  EXPECT_EQ(
      refusal("lighthouse", "{down: 2.2}"),
      "tilt and half of 'down' together must be below 90 deg: a tilted plane never "
      "reaches farther");
}

// σ ρ across and σ d up and down, wherever the point is: angles keep their noise.
TEST(Goniometer, HasTheSameAngleAnywhere) {
  const auto device_ =
      device("goniometer", "{sigma_azimuth: 1e-3, sigma_elevation: 2e-3}");
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(0, 0, 3), {4, -2, 1}, {-1, 5, -2}, {0.1, 0.2, -8}}) {
    const auto at = look(*device_, p);
    ASSERT_TRUE(at);
    const double level = std::hypot(p.x(), p.z()), d = p.norm();
    EXPECT_NEAR(at->H.row(0).norm(), 1 / level, 1e-12);
    EXPECT_NEAR(at->H.row(1).norm(), 1 / d, 1e-12);
    EXPECT_NEAR(at->H.row(0).dot(at->H.row(1)), 0, 1e-12);
    EXPECT_NEAR(at->z(1), -std::asin(p.y() / d), 1e-12);
    EXPECT_DOUBLE_EQ(at->R(0, 0), 1e-6);
    EXPECT_DOUBLE_EQ(at->R(1, 1), 4e-6);
  }
}

TEST(Goniometer, SeesUpToItsHighestElevation) {
  const auto all =
      device("goniometer", "{sigma_azimuth: 1, sigma_elevation: 1, highest: 1.2}");
  EXPECT_TRUE(look(*all, {0, -std::sin(1.19), -std::cos(1.19)}));
  EXPECT_FALSE(look(*all, {0, -std::sin(1.21), -std::cos(1.21)}));
  EXPECT_FALSE(look(*all, {0, std::sin(1.21), std::cos(1.21)}));
  const auto ahead =
      device("goniometer", "{sigma_azimuth: 1, sigma_elevation: 1, half_angle: 0.5}");
  EXPECT_TRUE(look(*ahead, {std::sin(0.499), 0, std::cos(0.499)}));
  EXPECT_FALSE(look(*ahead, {std::sin(0.501), 0, std::cos(0.501)}));
}

// z² s/(f B): 0.08 px, 640 px and 5 cm at 2 m, 1 cm; and the floor beside it.
TEST(DepthCamera, HasTheNoiseOfItsBaseline) {
  const auto stereo = device("depth_camera",
                             "{resolution: [1280, 720], f_x: 640, sigma: 0.3, "
                             "baseline: 0.05, subpixel: 0.08}");
  const auto at = look(*stereo, {0.5, -0.3, 2});
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->z(0), 640 + 640 * 0.25, 1e-10);
  EXPECT_DOUBLE_EQ(at->z(2), 2);
  EXPECT_NEAR(std::sqrt(at->R(2, 2)), 0.01, 1e-12);
  EXPECT_NEAR(at->R(0, 0), 0.09, 1e-15);
  const auto both = device("depth_camera",
                           "{resolution: [640, 480], f_x: 500, depth_sigma: 0.003, "
                           "depth_growth: 0.001}");
  EXPECT_NEAR(std::sqrt(look(*both, {0, 0, 2})->R(2, 2)), 0.005, 1e-12);  // 3, 4, 5
}

// Two parallel cameras are what it stands for: the middle of their image and their
// disparity say the same of depth.
TEST(DepthCamera, IsAStereoPair) {
  const double f = 700, b = 0.1, s = 0.2, z = 1.7;
  const auto depth =
      device("depth_camera",
             "{resolution: [1280, 960], f_x: 700, baseline: 0.1, subpixel: "
             "0.28284271247461906}");
  const auto camera =
      device("camera", "{resolution: [1280, 960], f_x: 700, sigma: 0.2}");
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  for (const double side : {-b / 2, b / 2}) {
    const auto at = look(*camera, {side, 0, z});
    S += at->H.transpose() * at->R.inverse() * at->H;
  }
  EXPECT_NEAR(std::sqrt(S.inverse()(2, 2)), std::sqrt(look(*depth, {0, 0, z})->R(2, 2)),
              1e-12);
  EXPECT_NEAR(std::sqrt(S.inverse()(2, 2)), z * z * std::sqrt(2.0) * s / (f * b),
              1e-12);
}

TEST(DepthCamera, RefusesWhatDoesNotSayItsDepth) {
  const auto says = [](const std::string& more) {
    return refusal("depth_camera", "{resolution: [640, 480], f_x: 500" + more + "}");
  };
  EXPECT_EQ(says(""),
            "how well is a depth measured? give depth_sigma, depth_growth, or baseline "
            "and subpixel");
  EXPECT_EQ(says(", baseline: 0.1"), "baseline and subpixel go together");
  EXPECT_EQ(says(", baseline: 0.1, subpixel: 0.1, depth_growth: 1"),
            "give either depth_growth or baseline and subpixel");
  EXPECT_EQ(says(", depth_sigma: 0.1, distortion: fisheye"),
            "measures depth along its axis, which a fisheye doesn't");
}

}  // namespace
}  // namespace delos::test
