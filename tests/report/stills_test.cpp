// Colours that compared maps share, and what a change is.
#include "report/stills.h"

#include <gtest/gtest.h>

#include <limits>

namespace delos::report {
namespace {

constexpr double kBlind = std::numeric_limits<double>::infinity();

/// A row of samples with these values.
Field row(const std::vector<double>& values) {
  Field field;
  field.metric = "eigmax";
  field.unit = "m";
  for (std::size_t i = 0; i < values.size(); ++i)
    field.samples.points.emplace_back(static_cast<double>(i), 0, 0);
  const auto count = static_cast<int>(values.size());
  field.samples.parts = {
      {"", 0, values.size(),
       PlaneShape{{0, 0, 0}, {count - 1.0, 0, 0}, {0, 1, 0}, {count, 1}}}};
  field.value = values;
  for (const double v : values) field.observable.push_back(v < kBlind);
  field.lost.resize(values.size());
  field.evaluated = values.size();
  return field;
}

TEST(CommonRange, HoldsAllFieldsAndGoesLogarithmic) {
  const Field a = row({0.001, 0.003}), b = row({0.002, 0.004, kBlind});
  ColourRange range = common_range({&a, &b}, false);
  EXPECT_EQ(range.low, 0.001);
  EXPECT_EQ(range.high, 0.004);
  EXPECT_FALSE(range.log10);
  const Field c = row({0.1});
  range = common_range({&a, &c}, false);
  EXPECT_TRUE(range.log10);
  EXPECT_NEAR(colour_position(range, 0.01), 0.5, 1e-12);  // of 0.001 … 0.1
}

TEST(Change, TakesTheEndWhereOneOfBothIsBlind) {
  const Field before = row({3, 2, kBlind, 5, kBlind}),
              after = row({1, 3, 4, kBlind, kBlind});
  const Change change = change_between(before, after, false);
  EXPECT_EQ(change.end, 2);  // of the changes −2 and 1
  EXPECT_EQ(change.gained, 1u);
  EXPECT_EQ(change.lost, 1u);
  EXPECT_EQ(change.field.value[0], -2);
  EXPECT_EQ(change.field.value[1], 1);
  EXPECT_EQ(change.field.value[2], -change.end);  // better: smaller
  EXPECT_EQ(change.field.value[3], change.end);   // worse
  EXPECT_EQ(change.field.value[4], kBlind);
  // The other way round where more is better.
  EXPECT_GT(change_between(before, after, true).field.value[2], 0);
}

}  // namespace
}  // namespace delos::report
