// Two devices at two rates under each fusion, through the program.
#include <gtest/gtest.h>

#include <cmath>

#include "program.h"

namespace delos::test {
namespace {

struct Row {
  double period[2];
  std::string variance[2];                            // m²
  double artemis, continuous, periodic, worst, best;  // standard deviations, mm
};

/// docs/theory.md, section 4: worked out with SciPy and by explicit filters, for one
/// coordinate with velocity, q = 0.3 m²/s³.
const Row kRows[] = {
    {{0.02, 0.02}, {"1e-3", "1e-3"}, 19.1714, 13.6426, 13.8003, 15.0164, 12.4662},
    {{0.02, 0.05}, {"1e-3", "1e-4"}, 14.9139, 9.6754, 10.1205, 12.7200, 7.6292},
    {{0.001, 0.033}, {"1e-6", "1e-5"}, 1.6885, 0.4309, 0.4322, 0.4523, 0.4086},
};
constexpr double kPrinted = 5e-5;  // four decimals, mm

/// Each device reads the position and leaves the velocity alone: H = [I 0].
std::string scene_of(const Row& row) {
  std::string text =
      "delos: 1\n"
      "motion: {type: position_velocity, state: position, q: [0.3, 0.3, 0.3]}\n"
      "sample: {points: [[0, 0, 0]]}\n"
      "devices:\n";
  for (int i = 0; i < 2; ++i) {
    const std::string& r = row.variance[i];
    text += "  - name: d" + std::to_string(i) +
            "\n    type: linear\n    rate: " + Json(1 / row.period[i]).dump() +
            "\n    params:\n"
            "      H: [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0]]\n"
            "      R: [[" +
            r + ", 0, 0], [0, " + r + ", 0], [0, 0, " + r + "]]\n";
  }
  return text;
}

Json report(const Row& row, const std::string& fusion) {
  const Folder folder;
  folder.write("scene.yaml", scene_of(row));
  const Finished done =
      run({"point", "scene.yaml", "--at", "0,0,0", "--fusion", fusion, "--json"},
          folder.path());
  EXPECT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  EXPECT_EQ(json["fusion"], fusion);
  return json;
}

double millimetres(const Json& P) { return 1e3 * std::sqrt(P[0][0].get<double>()); }

TEST(FusionModes, SumThePapersMatrices) {
  for (const Row& row : kRows) {
    EXPECT_NEAR(millimetres(report(row, "artemis")["P_prior"]), row.artemis, kPrinted);
  }
}

TEST(FusionModes, AddRatesOfInformation) {
  for (const Row& row : kRows) {
    const Json json = report(row, "continuous");
    EXPECT_NEAR(millimetres(json["P_prior"]), row.continuous, kPrinted);
    // Continuous time knows no prior that differs from the posterior.
    EXPECT_EQ(json["P_posterior"], json["P_prior"]);
  }
}

TEST(FusionModes, FollowTheCycleOfTheRates) {
  for (const Row& row : kRows) {
    const Json json = report(row, "periodic");
    EXPECT_NEAR(millimetres(json["P_prior"]), row.periodic, kPrinted);
    EXPECT_NEAR(millimetres(json["P_worst_prior"]), row.worst, kPrinted);
    EXPECT_NEAR(millimetres(json["P_best_posterior"]), row.best, kPrinted);
  }
}

/// Together at every update: the worst prior of the periodic cycle.
TEST(FusionModes, StackDevicesOfOneRate) {
  const Json json = report(kRows[0], "stacked");
  EXPECT_NEAR(millimetres(json["P_prior"]), kRows[0].worst, kPrinted);
  EXPECT_NEAR(millimetres(json["P_posterior"]), kRows[0].best, kPrinted);
  EXPECT_EQ(json.count("P_worst_prior"), 0u);
}

TEST(FusionModes, RefuseToStackDifferentRates) {
  const Folder folder;
  folder.write("scene.yaml", scene_of(kRows[1]));
  const Finished done =
      run({"check", "--set", "fusion=stacked", "--", "scene.yaml"}, folder.path());
  EXPECT_EQ(done.code, 1);
  EXPECT_NE(done.err.find("stacked needs one rate, but d0 has 50 Hz and d1 has 20 Hz; "
                          "use continuous or periodic"),
            std::string::npos)
      << done.err;
}

}  // namespace
}  // namespace delos::test
