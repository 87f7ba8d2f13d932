#include <gtest/gtest.h>

#include "output/fields.h"

namespace delos {
namespace {

// numpy 1.24.2: mean, median and percentile(…, 95) of the eleven values.
TEST(Statistics, AgreesWithNumpyOnAnOddCount) {
  const FieldStatistics s = summarize(
      scattered({0.31, 0.07, 2.5, 0.9, 0.11, 0.64, 1.75, 0.05, 0.42, 0.23, 3.125}));
  EXPECT_DOUBLE_EQ(s.mean, 0.9186363636363637);
  EXPECT_DOUBLE_EQ(s.median, 0.42);
  EXPECT_DOUBLE_EQ(s.p95, 2.8125);
}

// numpy 1.24.2, the first ten of them.
TEST(Statistics, AgreesWithNumpyOnAnEvenCount) {
  const FieldStatistics s =
      summarize(scattered({0.31, 0.07, 2.5, 0.9, 0.11, 0.64, 1.75, 0.05, 0.42, 0.23}));
  EXPECT_DOUBLE_EQ(s.mean, 0.6980000000000001);
  EXPECT_DOUBLE_EQ(s.median, 0.365);
  EXPECT_DOUBLE_EQ(s.p95, 2.162499999999999);
}

// By hand: of 1, 2, 3, 4 the mean and the median are 2.5; h = 0.95 · 3 = 2.85, so that
// p95 = 3 + 0.85.
TEST(Statistics, LeavesOutWhatIsNotFinite) {
  Field field = scattered({kBlind, 4, 2, std::nan(""), 1, 3, -kBlind});
  field.observable = {0, 1, 1, 1, 1, 0, 0};
  const FieldStatistics s = summarize(field);
  EXPECT_EQ(s.samples, 7u);
  EXPECT_EQ(s.observable, 4u);
  EXPECT_EQ(s.finite, 4u);
  EXPECT_EQ(s.min.value, 1);
  EXPECT_EQ(s.min.at, Eigen::Vector3d(4, 0.5, -0.25));
  EXPECT_EQ(s.max.value, 4);
  EXPECT_EQ(s.max.at, Eigen::Vector3d(1, 0.5, -0.25));
  EXPECT_EQ(s.mean, 2.5);
  EXPECT_EQ(s.median, 2.5);
  EXPECT_DOUBLE_EQ(s.p95, 3.85);
}

// By hand: of coverage 1, 1, 2, 3, 4 the 5th percentile is 1 (h = 0.2): 95 % of the
// samples reach it. The best is 4.
TEST(Statistics, KnowWhichWayIsBetter) {
  Field field = scattered({4, 1, 3, 1, 2});
  EXPECT_EQ(summarize(field).best().value, 1);
  EXPECT_EQ(summarize(field).worst().value, 4);
  field.larger_is_better = true;
  const FieldStatistics s = summarize(field);
  EXPECT_EQ(s.p95, 1);
  EXPECT_EQ(s.best().value, 4);
  EXPECT_EQ(s.worst().value, 1);
  EXPECT_EQ(s.worst().at.x(), 1);
  EXPECT_EQ(s.min.value, 1);
}

// By hand, two boxes of 2 m³ with two points each: the mean of 1, 3 and 5, 7 is 4; what
// is left of it, −3, −1 and 1, 3, differs by 2 within both boxes, so that its variance
// is (2² + 2²)/4². Three of four are observable; the parts' error is at least three
// points of four, which is what may have been missed.
TEST(Statistics, OfAVolumeHaveErrors) {
  Field points = scattered({1, 3, 5, 7});
  points.weight = {1, 1, 1, 1};
  points.observable = {1, 0, 1, 1};
  Field field = scattered({2, 9});
  field.spread = std::make_shared<const Field>(points);
  const FieldStatistics s = summarize(field);
  ASSERT_TRUE(s.volume.has_value());
  EXPECT_EQ(s.samples, 2u);
  EXPECT_EQ(s.mean, 4);
  EXPECT_EQ(s.min.value, 1);
  EXPECT_EQ(s.max.value, 9);
  EXPECT_NEAR(s.volume->mean_error, 1.959964 * std::sqrt(0.5), 1e-12);
  EXPECT_EQ(s.volume->observable, 0.75);
  EXPECT_EQ(s.volume->observable_error, 0.75);
  EXPECT_EQ(s.volume->points, 4u);
}

TEST(Statistics, NamesTheFirstOfEqualExtremes) {
  const FieldStatistics s = summarize(scattered({2, 1, 3, 1, 3}));
  EXPECT_EQ(s.min.at.x(), 1);
  EXPECT_EQ(s.max.at.x(), 2);
}

TEST(Statistics, OfOneValueAreThatValue) {
  const FieldStatistics s = summarize(scattered({kBlind, 0.25}));
  EXPECT_EQ(s.mean, 0.25);
  EXPECT_EQ(s.median, 0.25);
  EXPECT_EQ(s.p95, 0.25);
}

TEST(Statistics, AreZeroWhereNothingIsFinite) {
  const FieldStatistics s = summarize(scattered({kBlind, kBlind}));
  EXPECT_EQ(s.samples, 2u);
  EXPECT_EQ(s.finite, 0u);
  EXPECT_EQ(s.max.value, 0);
  EXPECT_EQ(s.p95, 0);
  EXPECT_EQ(summarize(empty_field()).samples, 0u);
}

}  // namespace
}  // namespace delos
