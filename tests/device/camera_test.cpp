#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "device/devices.h"
#include "device/look.h"

namespace delos::test {
namespace {

Eigen::Vector3d ray(double angle, double way = 0) {
  return {std::sin(angle) * std::cos(way), std::sin(angle) * std::sin(way),
          std::cos(angle)};
}

/// Degrees from the axis up to which the camera sees, that way about it.
double sees_to(const Device& camera, double way) {
  double seen = 0, unseen = std::numbers::pi;
  while (unseen - seen > 1e-9) {
    const double angle = (seen + unseen) / 2;
    (look(camera, 2 * ray(angle, way)) ? seen : unseen) = angle;
  }
  return seen / kDegree;
}

Eigen::Matrix3d information(const Observation& o) {
  return o.H.transpose() * o.R.inverse() * o.H;
}

// atan(400/1200) = 18.435° and atan(880/1200) = 36.254°, not 28.07° both.
TEST(Camera, SeesWhatItsImagesMiddleSays) {
  const auto camera =
      device("camera", "{resolution: [1280, 1024], f_x: 1200, c_x: 400}");
  EXPECT_NEAR(sees_to(*camera, std::numbers::pi), 18.4349, 1e-4);
  EXPECT_NEAR(sees_to(*camera, 0), 36.2538, 1e-4);
  EXPECT_NEAR(sees_to(*camera, std::numbers::pi / 2), 23.1063, 1e-4);  // atan 512/1200
}

// Three ways to say one lens, and the same as pinhole_camera, which reads in slopes.
TEST(Camera, WithoutDistortionIsAPinhole) {
  const auto pinhole = device(
      "pinhole_camera",
      "{focal: 0.006, pitch: 7.4e-6, resolution: [640, 480], sigma: 0.2, far: 9}");
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const char* way : {"f_x: 810.8108108108108", "focal: 0.006, pitch: 7.4e-6",
                          "field_of_view: 0.7518004748344423"}) {
    const auto camera =
        device("camera", "{resolution: [640, 480], sigma: 0.2, far: 9, " +
                             std::string(way) + "}");
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d p(2 * any(random), 2 * any(random), 5 + 5 * any(random));
      const auto a = look(*camera, p), b = look(*pinhole, p);
      ASSERT_EQ(a.has_value(), b.has_value()) << way << ' ' << p.transpose();
      if (!a) continue;
      ++seen;
      const Eigen::Matrix3d expected = information(*b);
      ASSERT_LT((information(*a) - expected).norm(), 1e-12 * expected.norm()) << way;
      ASSERT_NEAR(camera->footprint(p), pinhole->footprint(p), 1e-11);
      SmoothRows rows, plain;
      ASSERT_TRUE(camera->observe_smoothly(p, rows));
      ASSERT_TRUE(pinhole->observe_smoothly(p, plain));
      ASSERT_NEAR(rows.margin, plain.margin, 1e-12);
      ASSERT_LT((rows.margin_slope - plain.margin_slope).norm(), 1e-11);
    }
    EXPECT_GT(seen, 300);
  }
}

// The first camera of caliscope's sample calibration; the pixel by a script of OpenCV's
// formulas that knows nothing of Delos.
TEST(Camera, DistortsAsOpenCvSays) {
  const auto camera =
      device("camera",
             "{resolution: [1280, 720], f_x: 894.5288733178912, f_y: 896.877811780321, "
             "c_x: 624.011791468827, c_y: 361.28189843593503, k1: -0.3383569013465177, "
             "k2: 0.09672714756989992, p1: -0.0013512226751077358, "
             "p2: 0.003155760325647937, k3: -0.0037489346582201062}");
  const auto at = look(*camera, {0.5, -0.3, 1.2});
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->z(0), 970.8455685895796, 1e-9);
  EXPECT_NEAR(at->z(1), 152.75000771314592, 1e-9);
}

// Likewise of OpenCV's fisheye module, 100 degrees off the axis.
TEST(Camera, SeesBehindItselfThroughAFisheye) {
  const auto camera =
      device("camera",
             "{resolution: [1280, 800], f_x: 300, f_y: 310, distortion: fisheye, "
             "k1: -0.013, k2: 0.012, k3: -0.008, k4: 0.0015}");
  const auto at = look(*camera, {1, 0.5, -0.2});
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->z(0), 1097.1863275183728, 1e-9);
  EXPECT_NEAR(at->z(1), 636.2129358844926, 1e-9);
}

// f θ: a quarter turn lies at 960 · 90/190 px from the middle. The noise is the same
// angle anywhere: σ/f, and across the way from the axis σ sin θ/(f θ).
TEST(Camera, EquidistantFisheyeHasOneAngleAPixel) {
  const auto camera = device("camera",
                             "{resolution: [1920, 1920], field_of_view: "
                             "3.3161255787892263, distortion: fisheye}");
  EXPECT_NEAR(sees_to(*camera, 0), 95, 1e-6);
  const double f = 960 / (95 * kDegree);
  for (const double angle : {0.0, 1e-3, 0.0099, 0.0101, 0.5, 1.5, 1.6}) {
    const auto at = look(*camera, 2 * ray(angle, 0.3));
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->z(0), 960 + f * angle * std::cos(0.3), 1e-9);
    const Eigen::Vector3d outwards = ray(angle + 90 * kDegree, 0.3),
                          around(-std::sin(0.3), std::cos(0.3), 0);
    EXPECT_NEAR((at->H * outwards).norm(), f / 2, 1e-9);
    const double stretch = angle == 0 ? 1 : angle / std::sin(angle);
    EXPECT_NEAR((at->H * around).norm(), f / 2 * stretch, 1e-8);
    EXPECT_LT((at->H * ray(angle, 0.3)).norm(), 1e-9);
  }
}

// With k1 = −0.4 the image's radius is greatest at r = 1/√1.2 = 0.9129, 42.39° off the
// axis, at 0.6086: an image that reaches farther shows nothing more, and nothing from
// beyond comes back into it.
TEST(Camera, SeesNothingBeyondTheFoldOfItsModel) {
  const auto camera =
      device("camera", "{resolution: [1400, 1400], f_x: 1000, k1: -0.4}");
  EXPECT_NEAR(sees_to(*camera, 0), 42.39, 0.06);
  for (double angle = 43; angle < 90; angle += 0.5)
    ASSERT_FALSE(look(*camera, 3 * ray(angle * kDegree, 1))) << angle;
}

// Allen (2007), Eq. 49–51, with a distance in mm: 0.0000046 · 500 + 0.00195 = 0.00425,
// so that R(u) = (640 · 0.00425)² = 7.3984, R(v) = (480 · 0.00425)² = 4.1616 px², and
// at 30 degrees both over cos² = 0.75.
TEST(Camera, NoiseGrowsAsTheSourceMeasuredIt) {
  const auto camera = device(
      "camera", "{resolution: [640, 480], focal: 4e-3, pitch: 7.4e-6, noise: image}");
  const auto ahead = look(*camera, 0.5 * ray(0)),
             aside = look(*camera, 0.5 * ray(30 * kDegree));
  ASSERT_TRUE(ahead && aside);
  EXPECT_NEAR(ahead->R(0, 0), 7.3984, 1e-10);
  EXPECT_NEAR(ahead->R(1, 1), 4.1616, 1e-10);
  EXPECT_NEAR(aside->R(0, 0), 7.3984 / 0.75, 1e-10);
  EXPECT_NEAR(aside->R(1, 1), 4.1616 / 0.75, 1e-10);
}

// Two parallel cameras b apart: σ_z = z² σ_d/(f b) of a disparity's σ_d = √2 σ.
TEST(Camera, StereoHasTheDepthOfItsDisparity) {
  const auto camera =
      device("camera", "{resolution: [1280, 960], f_x: 900, sigma: 0.3}");
  for (const double z : {0.5, 2.0, 7.0}) {
    const double b = 0.12;
    const Eigen::Matrix3d S = information(*look(*camera, {b / 2, 0, z})) +
                              information(*look(*camera, {-b / 2, 0, z}));
    const double expected = z * z * std::numbers::sqrt2 * 0.3 / (900 * b);
    EXPECT_NEAR(std::sqrt(S.inverse()(2, 2)), expected, 1e-10 * expected);
  }
}

// 14 mm at f = 1000 px covers 3 px at 1000 · 0.014/3 = 4.6667 m.
TEST(Camera, SeesMarkersOfSoManyPixels) {
  const auto camera = device(
      "camera", "{resolution: [1000, 1000], f_x: 1000, marker: 0.014, least_size: 3}");
  EXPECT_TRUE(look(*camera, {1, 1, 4.6666}));
  EXPECT_FALSE(look(*camera, {1, 1, 4.6667}));
}

TEST(Camera, HasARoundViewOfItsHalfAngle) {
  const auto camera =
      device("camera", "{resolution: [1000, 1000], f_x: 500, half_angle: 0.6}");
  for (double way = 0; way < 6; way += 0.5)
    EXPECT_NEAR(sees_to(*camera, way), 0.6 / kDegree, 1e-6);
  SmoothRows rows;  // on the axis, too
  ASSERT_TRUE(camera->observe_smoothly({0, 0, 1}, rows));
  EXPECT_NEAR(rows.margin, std::sin(0.6), 1e-12);
  EXPECT_TRUE(rows.margin_slope.allFinite());
}

// By the Jacobian's smaller singular value, as of pinhole_camera.
TEST(Camera, HasTheFootprintOfItsJacobian) {
  const auto camera = device(
      "camera", "{resolution: [1280, 720], f_x: 900, f_y: 1000, k1: -0.3, p1: 0.01}");
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(0, 0, 2), {0.4, -0.2, 2}, {-1.1, 0.8, 3}}) {
    const auto at = look(*camera, p);
    ASSERT_TRUE(at);
    const Eigen::MatrixXd H = at->H;
    EXPECT_NEAR(camera->footprint(p) * H.jacobiSvd().singularValues()(1), 1, 1e-12);
  }
}

TEST(Camera, RefusesParametersThatClash) {
  const auto says = [](const std::string& more) {
    return refusal("camera", "{resolution: [640, 480], " + more + "}");
  };
  const char* const one = "give one of f_x (pixels), field_of_view, or focal and pitch";
  EXPECT_EQ(says("near: 1"), one);
  EXPECT_EQ(says("f_x: 800, field_of_view: 1"), one);
  EXPECT_EQ(says("f_x: 800, focal: 0.006, pitch: 5e-6"), one);
  EXPECT_EQ(says("focal: 0.006"), "focal and pitch go together");
  EXPECT_EQ(says("field_of_view: 1, f_y: 800"), "f_y goes with f_x");
  EXPECT_EQ(says("field_of_view: 3.2"),
            "a field_of_view of half a turn or more needs distortion: fisheye");
  EXPECT_EQ(says("f_x: 800, near: 2, far: 2"), "near must be less than far");
  EXPECT_EQ(says("f_x: 800, k4: 1"), "k4 is of distortion: fisheye or rational");
  EXPECT_EQ(says("f_x: 800, p1: 1, distortion: fisheye"),
            "p1 and p2 are of distortion: brown_conrady or rational");
  EXPECT_EQ(says("f_x: 800, distortion: fisheye, noise: image"),
            "noise: image is for lenses that aren't a fisheye");
  EXPECT_EQ(says("f_x: 800, least_size: 3"),
            "a least_size needs the diameter of what is seen, marker");
  EXPECT_EQ(refusal("camera", "{resolution: [640, 0], f_x: 800}"),
            "resolution must be a width and a height above 0");
}

}  // namespace
}  // namespace delos::test
