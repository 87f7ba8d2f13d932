// What scenes say of searches: variables by path, objectives, constraints.
#include <gtest/gtest.h>

#include <numbers>

#include "delos/scene/number.h"
#include "scene/load.h"

namespace delos::test {
namespace {

TEST(Variables, AreNumbersByPath) {
  Scene scene = scene_with(
      "variables:\n"
      "  - {path: devices.s1.at.z, lower: 80 cm, upper: 1.2}\n"
      "  - {path: devices.s1.params.gain}\n"
      "  - {path: devices.s2.aim.x, lower: -1, upper: 1}\n"
      "  - {path: groups.rig1.at.y, lower: -1, upper: 1}\n"
      "  - {path: motion.q.2, lower: 0.01, upper: 1, scale: log}\n");
  ASSERT_EQ(scene.variables.size(), 5u);
  EXPECT_EQ(scene.variables[0].lower, 0.8);
  // The plugin's table says how far a gain may go.
  EXPECT_EQ(scene.variables[1].lower, 0);
  EXPECT_EQ(scene.variables[1].upper, 1);
  EXPECT_EQ(scene.variables[4].scale, ParamScale::log);
  const auto z = find_number(scene, "devices.s1.at.z", plugins());
  EXPECT_EQ(std::get<SceneNumber>(z).value, &scene.devices[0].placement.at.z());
}

TEST(Variables, PatternsMeanManyAndVectorsTheirComponents) {
  const Scene scene = scene_with(
      "variables:\n"
      "  - {path: devices.s*.at, lower: [-1, -2, 0], upper: 3}\n"
      "  - {path: devices.s1.params.resolution, lower: 100, upper: 900}\n");
  std::vector<std::string> paths;
  for (const VariableEntry& v : scene.variables) paths.push_back(v.path);
  EXPECT_EQ(paths,
            (std::vector<std::string>{
                "devices.s1.at.x", "devices.s1.at.y", "devices.s1.at.z",
                "devices.s2.at.x", "devices.s2.at.y", "devices.s2.at.z",
                "devices.s1.params.resolution.0", "devices.s1.params.resolution.1"}));
  EXPECT_EQ(scene.variables[4].lower, -2);
}

TEST(Variables, AreFollowed) {
  const Scene scene = scene_with(
      "variables:\n"
      "  - path: devices.s1.at.x\n"
      "    lower: 0\n"
      "    upper: 2\n"
      "    mirror: {path: devices.s2.at.x, about: 1.5}\n"
      "    tie: devices.s2.at.y\n");
  const std::vector<Follower> expected = {{"devices.s2.at.y", 1, 0},
                                          {"devices.s2.at.x", -1, 3}};
  EXPECT_EQ(scene.variables.at(0).followers, expected);
}

TEST(SearchKeys, SurviveTheRoundTrip) {
  const Scene scene = scene_with(
      "regions: {stage: {box: {min: [-1, -1, -1], max: [2, 2, 2]}}}\n"
      "variables:\n"
      "  - {path: devices.s1.at.x, lower: 0, upper: 2, mirror: devices.s2.at.y}\n"
      "  - {path: devices.*.params.focal, upper: 1, scale: log}\n"
      "objective:\n"
      "  guess: 2\n"
      "  terms:\n"
      "    - {minimize: cvar, of: sigma_x, level: 90 %}\n"
      "    - {minimize: fraction, of: eigmax, limit: 1 mm, weight: 3}\n"
      "    - {maximize: mean, of: coverage}\n"
      "constraints:\n"
      "  - {inside: stage, devices: s1, margin: 10 cm}\n"
      "  - {outside: stage, devices: [s2]}\n"
      "  - {name: apart, spacing: 50 cm, devices: \"*\"}\n"
      "  - {tilt: 30 deg, devices: s2, from: [1, 0, 0]}\n"
      "  - {clear: [[0, 0, 0], [1, 1, 1]], distance: 0.2, devices: s1}\n"
      "  - {sum: {devices.*.rate: 2, devices.s1.at.x: 1}, at_most: 300}\n"
      "  - {metric: eigmax, below: 2 mm}\n"
      "  - {metric: coverage, above: 2}\n");
  ASSERT_EQ(scene.constraints.size(), 8u);
  EXPECT_EQ(std::get<KeepSum>(scene.constraints[5].what).factors.size(), 3u);
  const Loaded again = load(write_scene(scene));
  EXPECT_EQ(again.findings, std::vector<std::string>{});
  EXPECT_TRUE(again.scene == scene) << write_scene(scene);
}

TEST(SearchKeys, SayWhatIsWithstood) {
  const Scene scene = scene_with(
      "objective:\n"
      "  robust: {failures: \"*\", mounting: {at: 1 cm, angle: 180 deg}, noise: 10 %, "
      "draws: 8, seed: 3, combine: worst}\n");
  const Robustness& robust = scene.objective.robust;
  EXPECT_EQ(robust.failures, (std::vector<std::string>{"s1", "s2"}));
  EXPECT_EQ(robust.place, 0.01);
  EXPECT_DOUBLE_EQ(robust.angle, std::numbers::pi);
  EXPECT_EQ(robust.noise, 0.1);
  EXPECT_EQ(robust.draws, 8);
  EXPECT_EQ(robust.seed, 3);
  EXPECT_EQ(robust.combine, DrawRule::worst);
  const Loaded again = load(write_scene(scene));
  EXPECT_EQ(again.findings, std::vector<std::string>{});
  EXPECT_TRUE(again.scene == scene) << write_scene(scene);

  const Scene failing =
      scene_with("objective: {minimize: p_norm, guess: 2, robust: {failures: [s2]}}\n");
  EXPECT_EQ(failing.objective.terms.at(0).reduction, Reduction::p_norm);
  EXPECT_FALSE(failing.objective.robust.is_drawn());
  EXPECT_TRUE(load(write_scene(failing)).scene == failing) << write_scene(failing);
}

}  // namespace
}  // namespace delos::test
