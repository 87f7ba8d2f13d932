// Expected numbers: by hand, from the quadruple 3² + 4² + 12² = 13².
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "device/devices.h"

namespace delos::test {
namespace {

double sigma_at(const std::string& params, double distance) {
  Observation out;
  Target target;
  target.p_ST = {0, 0, distance};
  if (!device("range", params)->observe(target, out)) return -1;
  return std::sqrt(out.R(0, 0));
}

TEST(Range, IsTheDistanceWithConstantNoise) {
  Observation out;
  ASSERT_TRUE(device("range", "{sigma: 0.3}")->observe(kThirteenAway, out));
  EXPECT_DOUBLE_EQ(out.z(0), 13);
  EXPECT_LT((out.H - Eigen::RowVector3d(3, 4, 12) / 13).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(out.R(0, 0), 0.3 * 0.3);
  EXPECT_FALSE(device("range", "{}")->observe(Target{}, out));
}

// What the older ids say, it says too.
TEST(Range, IsWhatUwbAndSpeakersAre) {
  Observation of_range, of_other;
  const auto same = [&](const char* params, const char* id, const char* others) {
    ASSERT_TRUE(device("range", params)->observe(kThirteenAway, of_range));
    ASSERT_TRUE(device(id, others)->observe(kThirteenAway, of_other));
    EXPECT_NEAR(of_range.R(0, 0), of_other.R(0, 0), 1e-14 * of_other.R(0, 0)) << id;
  };
  same("{sigma: 0.05, growth: 0.01}", "uwb_range", "{sigma: 0.05, growth: 0.01}");
  same("{sigma: 1e-9, growth: 0.1}", "acoustic_range", "{r: 0.01}");
}

TEST(Range, TakesItsNoiseFromAFormulaOrATable) {
  const std::string formula =
      "{noise: expression, expression: \"0.02 + 0.01*d^2/(1 + d)\"}";
  EXPECT_NEAR(sigma_at(formula, 3), 0.02 + 0.09 / 4, 1e-15);
  const std::string table = "{noise: table, table: [[1, 0.1], [3, 0.5], [4, 0.2]]}";
  EXPECT_NEAR(sigma_at(table, 0.5), 0.1, 1e-15);
  EXPECT_NEAR(sigma_at(table, 1), 0.1, 1e-15);
  EXPECT_NEAR(sigma_at(table, 2.5), 0.4, 1e-15);
  EXPECT_NEAR(sigma_at(table, 3.5), 0.35, 1e-15);
  EXPECT_NEAR(sigma_at(table, 9), 0.2, 1e-15);
}

// Edges of a cone of 30 degrees and of one of 150, by tan.
TEST(Range, SeesInACone) {
  Observation out;
  const auto sees = [&](const char* params, double x, double z) {
    Target target;
    target.p_ST = {0.6 * x, 0.8 * x, z};
    return device("range", params)->observe(target, out);
  };
  const double edge = std::tan(std::numbers::pi / 6);
  const char *narrow = "{cone: 0.5235987755982988}",
             *wide = "{cone: 2.617993877991494}";
  EXPECT_TRUE(sees(narrow, edge - 1e-9, 1));
  EXPECT_FALSE(sees(narrow, edge + 1e-9, 1));
  EXPECT_TRUE(sees(narrow, 0, 1));
  EXPECT_FALSE(sees(narrow, 0, -1));
  EXPECT_TRUE(sees(wide, edge + 1e-9, -1));
  EXPECT_FALSE(sees(wide, edge - 1e-9, -1));
  EXPECT_TRUE(sees(wide, 1, 0));
  EXPECT_TRUE(sees("{}", 0, -1));
}

TEST(Range, RefusesWhatIsNoLaw) {
  EXPECT_EQ(refusal("range", "{noise: expression, expression: \"0.1*r\"}"),
            "'r' isn't known here; there are d");
  EXPECT_EQ(refusal("range", "{noise: table, table: [[1, 0.1], [1, 0.2]]}"),
            "table must have rising distances");
  EXPECT_EQ(refusal("range", "{noise: table, table: [[1, 0]]}"),
            "table must have distances of at least 0 and standard deviations above 0");
  EXPECT_EQ(refusal("range", "{noise: table, table: [[1, 0.1, 2]]}"),
            "table must have rows [distance, standard deviation]");
}

}  // namespace
}  // namespace delos::test
