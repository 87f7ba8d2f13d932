// Presets are what their plugins take.
#include "delos/scene/presets.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace delos
