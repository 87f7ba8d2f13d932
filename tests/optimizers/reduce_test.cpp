// Reductions of costs to one number: closed forms of small lists, and their slopes.
#include "problem/reduce.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace delos::test {
namespace {

const std::vector<double> kCosts = {3, 1, 4, 1.5, 9, 2.6};
const std::vector<double> kEven(6, 1.0 / 6);
const std::vector<double> kUneven = {0.1, 0.3, 0.2, 0.05, 0.15, 0.2};

ObjectiveTerm term(Reduction reduction) {
  ObjectiveTerm t;
  t.reduction = reduction;
  return t;
}

double value(const ObjectiveTerm& t, const std::vector<double>& weights = kEven) {
  return reduce(t, kCosts, weights, {}, nullptr);
}

TEST(Reduce, ClosedForms) {
  EXPECT_NEAR(value(term(Reduction::mean)), 21.1 / 6, 1e-14);
  EXPECT_NEAR(value(term(Reduction::mean), kUneven),
              0.3 + 0.3 + 0.8 + 0.075 + 1.35 + 0.52, 1e-14);
  EXPECT_EQ(value(term(Reduction::maximum)), 9);
  ObjectiveTerm two = term(Reduction::p_norm);
  two.power = 2;
  EXPECT_NEAR(value(two), std::sqrt((9 + 1 + 16 + 2.25 + 81 + 6.76) / 6), 1e-14);
  ObjectiveTerm median = term(Reduction::percentile);
  median.level = 0.5;  // numpy.percentile(costs, 50)
  EXPECT_NEAR(value(median), 2.8, 1e-14);
  ObjectiveTerm worst = term(Reduction::cvar);
  worst.level = 0.5;  // mean of 9, 4 and 3
  EXPECT_NEAR(value(worst), 16.0 / 3, 1e-13);
  ObjectiveTerm missed = term(Reduction::fraction);
  missed.limit = 2;
  EXPECT_NEAR(value(missed), 4.0 / 6, 1e-14);
}

// Between the mean and the greatest, and near the greatest where it is sharp.
TEST(Reduce, SoftMaximumIsBetweenMeanAndMaximum) {
  ObjectiveTerm soft = term(Reduction::soft_max);
  EXPECT_LT(value(soft), 9);
  EXPECT_GT(value(soft), 21.1 / 6);
  soft.sharpness = 1000;
  EXPECT_NEAR(value(soft), 9, 0.01);
  soft.sharpness = 1e-4;
  EXPECT_NEAR(value(soft), 21.1 / 6, 1e-3);
}

double blurred(ObjectiveTerm t, double blur) {
  return reduce(t, kCosts, kEven, blur, nullptr);
}

// Sorted: 1, 1.5, 2.6, 3, 4, 9.
TEST(Reduce, BlurLooksFartherThanTheWorst) {
  const double mean = 21.1 / 6;
  EXPECT_NEAR(blurred(term(Reduction::maximum), 1), mean, 1e-14);
  EXPECT_NEAR(blurred(term(Reduction::maximum), 1.0 / 3), (4 + 9) / 2.0, 1e-13);
  EXPECT_NEAR(blurred(term(Reduction::soft_max), 0.5), 16.0 / 3, 1e-13);
  ObjectiveTerm tail = term(Reduction::cvar);
  tail.level = 5.0 / 6;
  EXPECT_NEAR(blurred(tail, 0.5), 16.0 / 3, 1e-13);
  EXPECT_NEAR(blurred(tail, 0.01), 9, 1e-12);
  ObjectiveTerm median = term(Reduction::percentile);
  median.level = 0.5;
  EXPECT_NEAR(blurred(median, 1.0 / 3), 2.8, 1e-13);
  median.level = 5.0 / 6;  // from 1/2 on
  EXPECT_NEAR(blurred(median, 2.0 / 3), 16.0 / 3, 1e-13);
  ObjectiveTerm norm = term(Reduction::p_norm);
  norm.power = 8;
  EXPECT_NEAR(blurred(norm, 1), mean, 1e-14);
  EXPECT_NEAR(blurred(norm, 0.5), std::sqrt((9 + 1 + 16 + 2.25 + 81 + 6.76) / 6),
              1e-13);
  ObjectiveTerm missed = term(Reduction::fraction);
  missed.limit = 2;
  double sum = 0;  // steps as wide as the limit
  for (const double c : kCosts) sum += 1 / (6 * (1 + std::exp(-(c - 2) / 2)));
  EXPECT_NEAR(blurred(missed, 1), sum, 1e-14);
}

// Without blur a search sees what is judged, but for corners and steps.
TEST(Reduce, WithoutBlurIsWhatIsJudged) {
  for (const Reduction reduction :
       {Reduction::mean, Reduction::p_norm, Reduction::soft_max, Reduction::percentile,
        Reduction::cvar})
    EXPECT_EQ(blurred(term(reduction), 0), value(term(reduction)));
  const double greatest = blurred(term(Reduction::maximum), 0);
  EXPECT_GE(greatest, 9);
  EXPECT_LT(greatest, 9.01);
}

TEST(Reduce, SlopesMatchCentralDifferences) {
  for (const double blur : {0.0, 0.13, 0.45, 1.0})
    for (const Reduction reduction :
         {Reduction::mean, Reduction::p_norm, Reduction::soft_max, Reduction::maximum,
          Reduction::percentile, Reduction::cvar, Reduction::fraction}) {
      ObjectiveTerm t = term(reduction);
      t.level = 0.6;
      t.limit = 2.5;
      std::vector<double> slopes(kCosts.size());
      (void)reduce(t, kCosts, kUneven, blur, slopes.data());
      for (std::size_t i = 0; i < kCosts.size(); ++i) {
        constexpr double kStep = 1e-6;
        std::vector<double> up = kCosts, down = kCosts;
        up[i] += kStep;
        down[i] -= kStep;
        const double difference = (reduce(t, up, kUneven, blur, nullptr) -
                                   reduce(t, down, kUneven, blur, nullptr)) /
                                  (2 * kStep);
        EXPECT_NEAR(slopes[i], difference, 1e-8)
            << static_cast<int>(reduction) << " " << i;
      }
    }
}

}  // namespace
}  // namespace delos::test
