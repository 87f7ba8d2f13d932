// Tags that are read whole.
#include <Eigen/LU>
#include <numbers>

#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

/// A tag that faces up, below a camera that looks down.
std::string tag(const std::string& params, const std::string& points) {
  return "delos: 1\nmotion: {type: position, state: pose, q: [1, 1, 1, 1, 1, 1]}\n"
         "covariance: single\nmetric: sigma_z\nsample: {points: " +
         points +
         "}\n"
         "devices:\n  - {name: cam, type: fiducial, rate: 30, at: [0, 0, 2], aim: [0, "
         "0, "
         "0], params: {resolution: [1280, 960], f_x: 800, sigma: 0.2, size: 0.1" +
         params + "}}\n";
}

// Facing the camera at z, a tag of the edge s is f s/z pixels wide, of which four
// corners tell: σ_z = z² σ √2/(f s √(8/4) …): by hand, a corner (x, y, z) has ∂u/∂z =
// −f x/z², ∂v/∂z = −f y/z², and x² + y² = s²/2 at each of four, so that 1/σ_z² = 4 f²
// s²/(2 z⁴ σ²). By symmetry no other coordinate takes from it.
TEST(Fiducial, KnowsItsDistanceFromItsSize) {
  const double z = 2, expected = z * z * 0.2 / (800 * 0.1 * std::sqrt(2));
  EXPECT_NEAR(value_of(scene_of(tag("", "[[0, 0, 0]]")), "sigma_z"), expected,
              1e-9 * expected);
}

// A turn about the sight line moves each corner by its s/√2 at f/z pixels a metre:
// 1/σ² = 4 (s²/2) f²/(z² σ²).
TEST(Fiducial, KnowsItsTurnAboutTheSightLine) {
  const double expected = 2 * 0.2 / (800 * 0.1 * std::sqrt(2));
  EXPECT_NEAR(value_of(scene_of(tag("", "[[0, 0, 0]]")), "sigma_yaw"), expected,
              1e-9 * expected);
}

// The image ends at 2 · 640/800 = 1.6 m in x and 2 · 480/800 = 1.2 m in y: a tag whose
// edge is beyond is not read at all.
TEST(Fiducial, IsReadWholeOrNotAtAll) {
  Scene scene =
      scene_of(tag("", "[[1.549, 0, 0], [1.551, 0, 0], [0, 1.149, 0], [0, 1.151, 0]]"));
  scene.metric = "coverage";
  EXPECT_EQ(field_of(scene).value, (std::vector<double>{1, 0, 1, 0}));
}

// 40 px a tag at 2 m: f s/z = 800 · 0.1/2.
TEST(Fiducial, NeedsSoManyPixelsAndToFaceTheCamera) {
  const auto read = [](const std::string& more) {
    Scene scene = scene_of(tag(more, "[[0, 0, 0]]"));
    scene.metric = "coverage";
    return field_of(scene).value.at(0);
  };
  EXPECT_EQ(read(", least_size: 39.9"), 1);
  EXPECT_EQ(read(", least_size: 40.1"), 0);
  EXPECT_EQ(read(", tag_rpy: [60 deg, 0, 0], tag_half_angle: 61 deg"), 1);
  EXPECT_EQ(read(", tag_rpy: [60 deg, 0, 0], tag_half_angle: 59 deg"), 0);
  EXPECT_EQ(read(", tag_rpy: [180 deg, 0, 0]"), 0);
}

// Four marks of a camera, each seen by itself, say the same where all are seen.
TEST(Fiducial, IsFourMarksInOnePlace) {
  const std::string points = "[[0.3, -0.4, 0.2], [-0.5, 0.1, 0.6]]";
  Scene whole = scene_of(tag(", tag_at: [0.1, 0, 0.02]", points));
  std::string text = tag("", points);
  text.replace(text.find("fiducial"), 8, "camera");
  text.erase(text.find(", size: 0.1"), 11);
  text +=
      "target: {markers: [[0.05, -0.05, 0.02], [0.15, -0.05, 0.02], [0.15, 0.05, "
      "0.02], [0.05, 0.05, 0.02]]}\n";
  Scene marks = scene_of(text);
  for (const char* metric : {"sigma_position", "sigma_orientation"}) {
    whole.metric = marks.metric = metric;
    const Field a = field_of(whole), b = field_of(marks);
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(a.value[i], b.value[i], 1e-8 * b.value[i]) << metric;
  }
}

}  // namespace
}  // namespace delos::test
