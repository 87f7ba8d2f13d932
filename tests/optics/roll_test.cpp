// A roll beside an aim: cameras on their side.
#include <numbers>

#include "delos/scene/number.h"
#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

std::string camera(const std::string& facing) {
  return "delos: 1\nmotion: {type: position, q: [1, 1, 1]}\nmetric: coverage\n"
         "sample: {points: [[0.9, 0, 0], [0, 0, 0.9]]}\n"
         "devices: [{name: a, type: camera, rate: 1, at: [0, -2, 0], " +
         facing + ", params: {resolution: [1000, 800], f_x: 1000}}]\n";
}

// Of 1000 × 800 pixels, 0.9 m aside at 2 m is in the image across, not down; a quarter
// turn changes that.
TEST(Roll, PutsACameraOnItsSide) {
  EXPECT_EQ(field_of(scene_of(camera("aim: [0, 0, 0]"))).value,
            (std::vector<double>{1, 0}));
  EXPECT_EQ(field_of(scene_of(camera("aim: [0, 0, 0], roll: 90 deg"))).value,
            (std::vector<double>{0, 1}));
}

// Level, x is to the right and y down; a roll turns x towards y.
TEST(Roll, TurnsXTowardsY) {
  const Scene scene = scene_of(camera("aim: [0, 0, 0], roll: 30 deg"));
  const Pose pose = device_pose(scene, scene.devices[0]);
  const double c = std::cos(std::numbers::pi / 6), s = 0.5;
  EXPECT_LT((pose.R.col(0) - Eigen::Vector3d(c, 0, -s)).norm(), 1e-12);
  EXPECT_LT((pose.R.col(2) - Eigen::Vector3d(0, 1, 0)).norm(), 1e-12);
}

TEST(Roll, IsANumberOfTheSceneAndIsWritten) {
  Scene scene = scene_of(camera("aim: [0, 0, 0], roll: 30 deg"));
  const auto found = find_number(scene, "devices.a.roll", plugins());
  const auto* number = std::get_if<SceneNumber>(&found);
  ASSERT_TRUE(number);
  *number->value = 0.25;
  EXPECT_TRUE(scene_of(write_scene(scene)) == scene);
  EXPECT_EQ(
      std::get<Aim>(scene_of(write_scene(scene)).devices[0].placement.facing).roll,
      0.25);
}

TEST(Roll, GoesWithAnAim) {
  Diagnostics findings;
  EXPECT_FALSE(parse_scene(camera("rpy: [0, 0, 0], roll: 1"), "s.yaml", {}, plugins(),
                           findings));
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NE(to_string(findings[0]).find("devices.a.roll: goes with 'aim'"),
            std::string::npos)
      << to_string(findings[0]);
}

}  // namespace
}  // namespace delos::test
