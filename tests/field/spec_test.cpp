// Specifications: what they mean, and which samples meet them.
#include "delos/field/spec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/rigs.h"

namespace delos {
namespace {

StateLayout layout() { return testing::acoustic_system().motion.layout; }

Spec spec(const std::string& text) {
  return std::get<Spec>(parse_spec(text, layout()));
}

std::string problem(const std::string& text) {
  return std::get<std::string>(parse_spec(text, layout()));
}

TEST(Spec, ReadsMetricRelationAndUnit) {
  const Spec fine = spec(" eigmax<=1 mm ");
  EXPECT_EQ(fine.text, "eigmax<=1 mm");
  EXPECT_EQ(fine.metric.name, "eigmax");
  EXPECT_EQ(fine.relation, Relation::at_most);
  EXPECT_DOUBLE_EQ(fine.limit, 1e-3);
  EXPECT_EQ(spec("coverage >= 3").relation, Relation::at_least);
  EXPECT_EQ(spec("coverage > 2").relation, Relation::above);
  EXPECT_EQ(spec("sigma_x < 2 cm").relation, Relation::below);
  EXPECT_DOUBLE_EQ(spec("sigma_vx < 2").limit, 2);
}

TEST(Spec, SaysWhatIsWrong) {
  for (const char* text : {"", "coverage", "coverage = 3", "coverage >= ", "<= 3",
                           "coverage >== 3", "1 < coverage < 3"})
    EXPECT_FALSE(problem(text).empty()) << text;
  EXPECT_NE(problem("coverage = 3").find("write METRIC <= VALUE"), std::string::npos);
  EXPECT_NE(problem("covrage >= 3").find("unknown metric 'covrage'"),
            std::string::npos);
  EXPECT_NE(problem("eigmax <= 1 s").find("m"), std::string::npos);
}

// By hand: of 1, 2, 3, 3, blind and NaN, and 9 within a solid.
TEST(Spec, CountsSamplesOutsideSolidsAndNoBlindOnes) {
  Field field;
  field.value = {1, 2, 3, 3, INFINITY, NAN, 9};
  field.inside = {0, 0, 0, 0, 0, 0, 1};
  const auto share = [&](const char* text) { return share_meeting(field, spec(text)); };
  EXPECT_EQ(share("coverage >= 3").samples, 6u);
  EXPECT_EQ(share("coverage >= 3").met, 2u);
  EXPECT_DOUBLE_EQ(share("coverage >= 3").share, 2.0 / 6);
  EXPECT_EQ(share("coverage > 3").met, 0u);
  EXPECT_EQ(share("coverage <= 3").met, 4u);
  EXPECT_EQ(share("coverage < 3").met, 2u);
  EXPECT_EQ(share("coverage <= 1e300").met, 4u);
  EXPECT_EQ(share("coverage >= -1e300").met, 4u);
  field.weight = {1, 1, 4, 1, 1, 0, 100};  // volumes
  EXPECT_DOUBLE_EQ(share("coverage >= 3").share, 5.0 / 8);
  EXPECT_EQ(share("coverage >= 3").met, 2u);
}

TEST(Spec, OfNoSampleIsMetByNone) {
  EXPECT_EQ(share_meeting({}, spec("coverage >= 3")).share, 0);
}

}  // namespace
}  // namespace delos
