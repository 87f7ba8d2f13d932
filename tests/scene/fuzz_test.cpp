// Scenes with random damage: always a scene or findings, never a crash or neither.
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <string>

#include "scene/room.h"

namespace delos::test {
namespace {

/// Replace, remove, insert, or copy some bytes.
std::string damaged(std::string text, std::mt19937& random) {
  const auto upto = [&](std::size_t n) {
    return static_cast<std::size_t>(random() % (n + 1));
  };
  static const std::string kBytes =
      "[]{}:,-#&*!|>'\"%@`~?.0123456789eE+xn \n\t\r\\/\0\xff\xc3";
  for (std::size_t edits = 1 + upto(3); edits > 0 && !text.empty(); --edits) {
    const std::size_t at = upto(text.size() - 1);
    switch (upto(3)) {
      case 0:
        text[at] = kBytes[upto(kBytes.size() - 1)];
        break;
      case 1:
        text.erase(at, 1 + upto(8));
        break;
      case 2:
        text.insert(at, 1, kBytes[upto(kBytes.size() - 1)]);
        break;
      default:
        text.insert(at, text.substr(upto(text.size() - 1), 1 + upto(40)));
    }
  }
  return text;
}

void expect_a_scene_or_findings(const std::string& good) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(400);
  std::mt19937 random(20);
  int refused = 0;
  for (int i = 0; i < 2000 && std::chrono::steady_clock::now() < end; ++i) {
    const std::string text = damaged(good, random);
    const Loaded loaded = load(text);
    ASSERT_NE(loaded.scene.has_value(), !loaded.findings.empty()) << text;
    if (!loaded.scene) ++refused;
    if (loaded.scene) {
      const std::string written = write_scene(*loaded.scene);
      ASSERT_EQ(load(written).scene, loaded.scene) << text << "\nwritten:\n" << written;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(Fuzz, DamagedScenesGiveASceneOrFindings) { expect_a_scene_or_findings(kGood); }

TEST(Fuzz, DamagedRoomsGiveASceneOrFindings) { expect_a_scene_or_findings(kRoom); }

TEST(Fuzz, DamagedOverridesGiveASceneOrFindings) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(200);
  std::mt19937 random(21);
  for (int i = 0; i < 1000 && std::chrono::steady_clock::now() < end; ++i) {
    const Override change{damaged("devices.s1.params.r", random),
                          damaged("{r: [5 mm, 2]}", random)};
    const Loaded loaded = load(kGood, {change});
    ASSERT_NE(loaded.scene.has_value(), !loaded.findings.empty())
        << change.path << " = " << change.value;
  }
}

}  // namespace
}  // namespace delos::test
