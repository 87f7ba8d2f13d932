#include "delos/device/parameters.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace delos {
namespace {

ParamValues filled() {
  ParamValues p;
  p.set("focal", 0.006);
  p.set("noise", std::string("pixels"));
  p.set("resolution", Eigen::MatrixXd(Eigen::Vector2d(640, 480)));
  return p;
}

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::out_of_range& e) {
    return e.what();
  }
  return "accepted";
}

TEST(ParamValues, GivesWhatWasSet) {
  const ParamValues p = filled();
  EXPECT_EQ(p["focal"], 0.006);
  EXPECT_EQ(p.choice("noise"), "pixels");
  EXPECT_EQ(p.matrix("resolution"), Eigen::Vector2d(640, 480));
}

TEST(ParamValues, ReplacesInPlace) {
  ParamValues p = filled();
  p.set("focal", 0.008);
  ASSERT_EQ(p.all().size(), 3u);
  EXPECT_EQ(p.all()[0].first, "focal");
  EXPECT_EQ(p["focal"], 0.008);
}

TEST(ParamValues, NamesWhatIsntThere) {
  const ParamValues p = filled();
  EXPECT_EQ(refusal([&] { (void)p["focall"]; }), "there is no parameter 'focall'");
  EXPECT_EQ(refusal([&] { (void)p["noise"]; }), "parameter 'noise' is not a number");
  EXPECT_EQ(refusal([&] { (void)p.choice("focal"); }),
            "parameter 'focal' is not a choice");
  EXPECT_EQ(refusal([&] { (void)p.matrix("focal"); }),
            "parameter 'focal' is not a vector or matrix");
}

TEST(ParamValues, EqualWhereNamesOrderAndNumbersAre) {
  EXPECT_EQ(filled(), filled());
  ParamValues other = filled();
  other.set("focal", 0.0061);
  EXPECT_FALSE(filled() == other);
  ParamValues named, otherwise;
  named.set("focal", 0.006);
  otherwise.set("pitch", 0.006);
  EXPECT_FALSE(named == otherwise);
  ParamValues longer = filled();
  longer.set("sigma", 0.1);
  EXPECT_FALSE(filled() == longer);
}

TEST(SameValue, ComparesKindsShapesAndNumbers) {
  const Eigen::MatrixXd row = Eigen::RowVector2d(1, 2), column = Eigen::Vector2d(1, 2);
  EXPECT_TRUE(same_value(row, row));
  EXPECT_FALSE(same_value(row, column));
  EXPECT_FALSE(same_value(column, Eigen::MatrixXd(Eigen::Vector2d(1, 3))));
  EXPECT_TRUE(same_value(1.0, 1.0));
  EXPECT_FALSE(same_value(1.0, 2.0));
  EXPECT_FALSE(same_value(1.0, std::string("1")));
  EXPECT_FALSE(same_value(1.0, Eigen::MatrixXd::Ones(1, 1).eval()));
  EXPECT_TRUE(same_value(std::string("a"), std::string("a")));
  EXPECT_FALSE(same_value(std::string("a"), std::string("b")));
}

}  // namespace
}  // namespace delos
