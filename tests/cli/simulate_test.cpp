// delos simulate.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "cli/program.h"

namespace delos::test {
namespace {

TEST(Simulate, PrintsPredictedMeasuredRatioAndNeesWithItsBand) {
  const Finished done = run({"simulate", scene("01-acoustic"), "--at", "0.2,0.2,0.4",
                             "--runs", "300", "--seed", "1", "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  EXPECT_EQ(json["runs"], 300);
  EXPECT_EQ(json["seed"], 1);
  const Json& point = json["points"][0];
  EXPECT_EQ(point["at"], Json::parse("[0.2, 0.2, 0.4]"));
  for (const std::string state : json["state"]) {
    const double predicted = point["predicted"][state],
                 measured = point["measured"][state];
    EXPECT_DOUBLE_EQ(point["ratio"][state], measured / predicted);
    // 300 runs know a σ to 4 %.
    EXPECT_NEAR(measured / predicted, 1, 0.2) << state;
    EXPECT_NEAR(point["ratio_error"][state], 1 / std::sqrt(600.0), 0.02) << state;
  }
  EXPECT_EQ(point["nees"]["expected"], 6);
  EXPECT_EQ(point["nees"]["band"].size(), 2u);
  // Wilson and Hilferty's χ² quantiles of 1800 degrees, over 300.
  EXPECT_NEAR(point["nees"]["band"][0], 5.6144, 0.0005);
  EXPECT_NEAR(point["nees"]["band"][1], 6.3983, 0.0005);
  EXPECT_EQ(json["nis"]["expected"], 4);
  EXPECT_TRUE(json["converged_after"].is_number());
  EXPECT_TRUE(point["covariances"].contains("posterior"));
}

/// Where the noise is small beside what bends the readings, filters are consistent:
/// ranges, cameras, a HiBall at 1 kHz, UWB, bearings in a plane, inertial sensors on a
/// target that turns.
TEST(Simulate, FindsConsistentFiltersOnShippedScenes) {
  const std::vector<std::vector<std::string>> commands = {
      {"01-acoustic", "0.2,0.2,0.4", "400", "0.8"},
      {"05-optitrack-lab", "0,0,1", "150", "0.2"},
      {"15-uwb-anchors", "4,3,1.5", "150", "0.5"},
      {"18-floor-robot", "3,3,0", "150", "20"},
      {"19-inertial-camera", "1.5,1.5,1.3", "40", "0.2"},
      {"25-tdoa", "3,3,1", "150", "2"},  // readings that a clock shifts
      {"hiball/six-lepd", "4.5,7.5,1.9", "60", "0.1"},
  };
  for (const auto& c : commands) {
    const Finished done = run({"simulate", scene(c[0]), "--at", c[1], "--runs", c[2],
                               "--seconds", c[3], "--covariance", "prior", "--json"});
    ASSERT_EQ(done.code, 0) << c[0] << done.err;
    const Json json = done.json();
    const Json& nees = json["points"][0]["nees"];
    // Within its band, widened by 5 % for what bends.
    const double room = 0.05 * nees["expected"].get<double>();
    EXPECT_GT(nees["mean"].get<double>(), nees["band"][0].get<double>() - room) << c[0];
    EXPECT_LT(nees["mean"].get<double>(), nees["band"][1].get<double>() + room) << c[0];
    EXPECT_LT(json["points"][0]["lost"].get<int>(), std::stoi(c[2]) / 20) << c[0];
  }
}

TEST(Simulate, TakesTheBestMedianAndWorstPlace) {
  const Finished done =
      run({"simulate", scene("01-acoustic"), "--runs", "4", "--seconds", "0.2"});
  ASSERT_EQ(done.code, 0) << done.err;
  for (const char* name : {"best place", "median place", "worst place", "NEES"})
    EXPECT_NE(done.out.find(name), std::string::npos) << done.out;
}

TEST(Simulate, WritesAPathWithItsTube) {
  const Folder folder;
  const std::filesystem::path path = folder.path() / "walk.csv";
  std::ofstream(path) << "t,x,y,z\n0,0.1,0.1,0.4\n1,0.3,0.1,0.4\n2,0.3,0.3,0.4\n";
  const Finished done =
      run({"simulate", scene("01-acoustic"), "--path", path.string(), "--runs", "4",
           "--out", (folder.path() / "walk.svg").string(), "--json"});
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  const Json& rows = json["points"][0]["path"];
  ASSERT_EQ(rows.size(), 100u);  // 2 s at 50 Hz
  EXPECT_NEAR(rows.back()["at"][0], 0.3, 1e-9);
  EXPECT_GT(rows.back()["predicted"]["x"], 0.01);
  EXPECT_NE(read_file(folder.path() / "walk.svg").find("</svg>"), std::string::npos);
}

/// Out of the laboratory for two seconds, and back.
TEST(Simulate, SaysThatAPathLeavesTheVolumeAndThatFiltersCoast) {
  const Folder folder;
  const std::filesystem::path path = folder.path() / "out.csv";
  std::ofstream(path) << "t,x,y,z\n0,0,0,1.5\n0.5,0,0,1.5\n1,0,30,1.5\n"
                         "3,0,30,1.5\n3.5,0,0,1.5\n4,0,0,1.5\n";
  const Finished done = run(
      {"simulate", scene("05-optitrack-lab"), "--path", path.string(), "--runs", "4"});
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_NE(done.err.find("2 of the path's 6 points lie outside the box"),
            std::string::npos)
      << done.err;
  EXPECT_NE(done.out.find("coasted: 4 runs had no reading for longer than a cycle, "
                          "at most 2."),
            std::string::npos)
      << done.out;
  EXPECT_NE(done.out.find("instants without a finite P∞ are left out"),
            std::string::npos)
      << done.out;
}

TEST(Simulate, SaysThatRatesHaveNoCycle) {
  const Finished done = run({"simulate", scene("03-hybrid"), "--fusion", "periodic",
                             "--set", "devices.*.rate=31.4159265 Hz", "--set",
                             "devices.s1.rate=27.1828 Hz", "--at", "0.2,0.2,0.5"});
  EXPECT_EQ(done.code, 1);
  EXPECT_NE(done.err.find("rates"), std::string::npos) << done.err;
}

TEST(Simulate, RefusesWhatIsWrongWithAPathLineByLine) {
  const Folder folder;
  const std::filesystem::path path = folder.path() / "walk.csv";
  std::ofstream(path) << "0,0.1,0.1,0.4\n1,zwei,0.1,0.4\n2,0.3,0.3\n";
  const Finished done =
      run({"simulate", scene("01-acoustic"), "--path", path.string()});
  EXPECT_EQ(done.code, 1);
  EXPECT_NE(done.err.find("walk.csv:2:3: error: 'zwei' isn't a number"),
            std::string::npos)
      << done.err;
  EXPECT_NE(done.err.find("walk.csv:3:"), std::string::npos) << done.err;
  std::ofstream(path) << "0,0.1,0.1,0.4\n2,0.1,0.1,0.4\n1,0.3,0.3,0.4\n";
  const Finished back =
      run({"simulate", scene("01-acoustic"), "--path", path.string()});
  EXPECT_EQ(back.code, 1);
  EXPECT_NE(back.err.find("row 3 isn't later"), std::string::npos) << back.err;
}

TEST(Simulate, RefusesOptionsThatDontFit) {
  const auto usage = [](std::vector<std::string> more) {
    std::vector<std::string> all = {"simulate", scene("01-acoustic")};
    all.insert(all.end(), more.begin(), more.end());
    return run(all).code;
  };
  EXPECT_EQ(usage({"--filter", "kalman"}), 2);
  EXPECT_EQ(usage({"--runs", "1"}), 2);
  EXPECT_EQ(usage({"--seconds", "-1"}), 2);
  EXPECT_EQ(usage({"--at", "0,0,0", "--out", "x.png"}), 2);
  EXPECT_EQ(usage({"--at", "0,0,0", "--path", "walk.csv"}), 2);
  EXPECT_EQ(run({"simulate", scene("18-floor-robot"), "--at", "1,1,0"}).code, 1);
}

}  // namespace
}  // namespace delos::test
