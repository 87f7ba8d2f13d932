// Presets are what their plugins take.
#include "delos/scene/presets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "delos/rig/system.h"
#include "delos/scene/io.h"

namespace delos {
namespace {

TEST(Presets, AreTakenByTheirPlugins) {
  PluginRegistry plugins({DELOS_PLUGINS});
  ASSERT_GE(device_presets().size(), 10u);
  for (const DevicePreset& preset : device_presets()) {
    const std::string mount =
        std::string(preset.type) == "imu" ? ", mount: target" : "";
    std::string params = preset.params;
    if (preset.add[0] != 0) params += std::string(", ") + preset.add;
    const std::string rate =
        params.find("readings: 400") != params.npos ? "400" : "200";
    const std::string text =
        "delos: 1\nmotion: {type: position_velocity_acceleration, state: pose, q: [1, "
        "1, "
        "1, 1, 1, 1]}\nmetric: sigma_position\nsample: {points: [[0, 0, "
        "1]]}\ndevices:\n"
        "  - {name: a, type: " +
        std::string(preset.type) + ", rate: " + rate + mount + ", params: {" + params +
        "}}\n";
    Diagnostics findings;
    const auto scene = parse_scene(text, "s.yaml", {}, plugins, findings);
    ASSERT_TRUE(scene) << preset.name << ": " << to_string(findings.at(0));
    EXPECT_NO_THROW((void)build_system(*scene, plugins)) << preset.name;
    EXPECT_NE(std::string(preset.source), "") << preset.name;
  }
}

// 1280 x 1024 behind 1201.8 and 1203.6 px, and 2352 x 1728 of 7 µm behind 20 mm, are
// the angles that their sources state.
TEST(Presets, HaveTheAnglesThatTheirSourcesState) {
  const auto degrees = [](double half, double f) {
    return 2 * std::atan(half / f) * 180 / M_PI;
  };
  EXPECT_NEAR(degrees(640, 1201.8), 56.1, 0.05);
  EXPECT_NEAR(degrees(512, 1203.6), 46.1, 0.05);
  EXPECT_NEAR(degrees(2352 * 0.0035, 20), 44.8, 0.06);
  EXPECT_NEAR(degrees(1728 * 0.0035, 20), 33.7, 0.05);
}

/// A scene of one device, and what is said of it.
std::optional<Scene> scene_of_one(const std::string& device, std::string& findings) {
  static PluginRegistry plugins({DELOS_PLUGINS});
  Diagnostics all;
  auto scene = parse_scene(
      "delos: 1\nmotion: {type: position, q: [1, 1, 1]}\nsample: {points: [[0, 0, "
      "1]]}\n"
      "devices:\n  - {name: a, rate: 10 Hz, " +
          device + "}\n",
      "s.yaml", {}, plugins, all);
  findings.clear();
  for (const Diagnostic& one : all) findings += to_string(one) + '\n';
  return scene;
}

TEST(Presets, FillInParametersOfAScene) {
  std::string findings;
  const auto scene = scene_of_one("preset: Marvelmind, params: {reach: 20}", findings);
  ASSERT_TRUE(scene) << findings;
  EXPECT_EQ(scene->devices[0].type, "range");
  EXPECT_EQ(scene->devices[0].params["sigma"], 0.02);
  EXPECT_EQ(scene->devices[0].params["reach"], 20);
  EXPECT_EQ(scene->devices[0].params["growth"], 0) << "the table's";
  ASSERT_EQ(preset_sources(*scene).size(), 1u);
  EXPECT_NE(preset_sources(*scene)[0].find("Marvelmind: manual"), std::string::npos);
  const auto other =
      scene_of_one("type: range, preset: Marvelmind, params: {sigma: 5 cm}", findings);
  ASSERT_TRUE(other) << findings;
  EXPECT_EQ(other->devices[0].params["sigma"], 0.05) << "what is said counts before it";
  PluginRegistry plugins({DELOS_PLUGINS});
  Diagnostics none;
  const auto again = parse_scene(write_scene(*other), "s.yaml", {}, plugins, none);
  ASSERT_TRUE(again);
  EXPECT_EQ(*again, *other);
}

TEST(Presets, AreRefusedWhereTheyAreNone) {
  std::string findings;
  EXPECT_FALSE(scene_of_one("preset: Marvelmint", findings));
  EXPECT_NE(findings.find("did you mean 'Marvelmind'?"), std::string::npos) << findings;
  EXPECT_FALSE(scene_of_one("preset: Marvelmind, type: camera", findings));
  EXPECT_NE(findings.find("is of a range, not of a camera"), std::string::npos)
      << findings;
  EXPECT_FALSE(scene_of_one("phase: 0", findings));
  EXPECT_NE(findings.find("type: missing: id of the plugin"), std::string::npos)
      << findings;
  // What isn't published is asked for.
  EXPECT_FALSE(scene_of_one("preset: RealSense D435", findings));
  EXPECT_NE(findings.find("resolution"), std::string::npos) << findings;
}

}  // namespace
}  // namespace delos
