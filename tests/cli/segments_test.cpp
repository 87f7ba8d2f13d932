// A recording that stands still and then walks.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "program.h"

namespace delos::test {
namespace {

TEST(FitMotionCommand, CutsARecording) {
  const Folder folder;
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::string text = "t [s],x [m],y [m],z [m]\n";
  double p[3] = {}, v[3] = {};
  for (int i = 0; i < 900; ++i) {
    text += std::to_string(i * 0.02);
    for (int a = 0; a < 3; ++a) {
      if (i >= 500) {
        v[a] += std::sqrt(0.5 * 0.02) * normal(random);
        p[a] += v[a] * 0.02;
      }
      text += "," + std::to_string(p[a] + 1e-3 * normal(random));
    }
    text += "\n";
  }
  folder.write("walk.csv", text);
  const Finished done =
      run({"fit-motion", "walk.csv", "--segments", "--json"}, folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const auto json = done.json();
  ASSERT_EQ(json["segments"].size(), 2u);
  EXPECT_EQ(json["segments"][0]["still"], true);
  EXPECT_NEAR(json["segments"][1]["from"].get<double>(), 10, 0.4);
  EXPECT_EQ(json["segments"][1]["best"], "position_velocity");
}

}  // namespace
}  // namespace delos::test
