// delos sample-time and delos fit-motion from end to end.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "program.h"

namespace delos::test {
namespace {

/// The published optimum and crossover of Fig. 7.7 (session/answer_test has the rest).
TEST(SampleTimeCommand, PrintsOptimumCrossoverAndCurve) {
  const Folder folder;
  const Finished done =
      run({"sample-time", scene("31-photodiode-window"), "--motion", "update",
           "--deviations", "--from", "21 us", "--to", "315 us", "--step", "21 us",
           "--out", "curves.html", "--json"},
          folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const auto point = done.json()["points"][0];
  EXPECT_EQ(point["times"].size(), 15u);
  const auto row = point["rows"][0];
  EXPECT_EQ(row["best_drawn"], 7);
  EXPECT_NEAR(row["sum"][7].get<double>(), 1.5636e-4, 5e-9);
  EXPECT_NEAR(row["crossover"].get<double>(), 182.5e-6, 5e-8);
  EXPECT_GT(row["metric_at_optimum"].get<double>(),
            point["metric"]["value"].get<double>());
  const std::string page = read_file(folder.path() / "curves.html");
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(page.find("crossover 18"), std::string::npos);
}

TEST(SampleTimeCommand, RefusesWhatItCantAnswer) {
  const auto refused = [](std::vector<std::string> words, int code,
                          const std::string& part) {
    words.insert(words.begin(), "sample-time");
    const Finished done = run(words);
    EXPECT_EQ(done.code, code) << done.err;
    EXPECT_NE(done.err.find(part), std::string::npos) << done.err;
    EXPECT_EQ(done.out, "");
  };
  refused({scene("01-acoustic"), "--at", "0,0,0"}, 1, "no device says how its noise");
  refused({scene("30-averaged-speakers")}, 2, "say by --at X,Y,Z where");
  const std::string led = scene("32-rotating-led");
  refused({led, "--motion", "drift"}, 2, "choose exact, instantaneous");
  refused({led, "--motion", "blur"}, 2, "needs a --speed");
  refused({led, "--speed", "1"}, 2, "goes with --motion blur");
  refused({led, "--from", "2 ms", "--to", "1 ms"}, 2, "--to must be above 2 ms");
  refused({led, "--from", "1 m"}, 2, "--from '1 m'");
  refused({led, "--device", "c"}, 1, "there is no device 'c'");
}

TEST(FitMotionCommand, PrintsABlockThatASceneTakes) {
  const Folder folder;
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::string text = "t [s],x [mm],y [mm],z [mm]\n";
  // A random walk of q = 1e-4 m²/s, seen to 0.5 mm.
  double p[3] = {};
  for (int i = 0; i < 1500; ++i) {
    text += std::to_string(i * 0.02);
    for (double& x : p) {
      x += std::sqrt(1e-4 * 0.02) * normal(random);
      text += "," + std::to_string(1000 * (x + 5e-4 * normal(random)));
    }
    text += "\n";
  }
  folder.write("walk.csv", text);
  const Finished done = run({"fit-motion", "walk.csv", "--json"}, folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const auto json = done.json();
  EXPECT_EQ(json["best"], "position");
  EXPECT_EQ(json["fits"], true);
  for (const auto& axis : json["orders"][0]["axes"]) {
    EXPECT_LT(axis["q"]["low"].get<double>(), 1e-4);
    EXPECT_GT(axis["q"]["high"].get<double>(), 1e-4);
  }
  folder.write("scene.yaml",
               "delos: 1\n" + json["motion"].get<std::string>() +
                   "sample: {points: [[0, 0, 0]]}\ndevices:\n"
                   "  - {name: a, type: uwb_range, rate: 10 Hz, at: [1, 0, 0]}\n");
  EXPECT_EQ(run({"check", "scene.yaml"}, folder.path()).code, 0);

  const Finished words = run({"fit-motion", "walk.csv"}, folder.path());
  EXPECT_NE(words.out.find("type: position\n"), std::string::npos) << words.out;
  EXPECT_NE(words.out.find("whiteness p = "), std::string::npos);
  EXPECT_EQ(run({"fit-motion", "walk.csv", "--to", "0.1 s"}, folder.path()).code, 1);
  EXPECT_EQ(run({"fit-motion", "walk.csv", "--marker", "b"}, folder.path()).code, 2);
  const Finished bad = run({"fit-motion", "none.csv"}, folder.path());
  EXPECT_EQ(bad.code, 1);
  EXPECT_EQ(bad.err, "none.csv: error: there is no such file\n");
}

}  // namespace
}  // namespace delos::test
