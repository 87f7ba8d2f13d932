// Reductions of costs to one number: closed forms of small lists, and their slopes.
#include "src/reduce.h"

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
  return reduce(t, kCosts, weights, false, nullptr);
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

TEST(Reduce, SlopesMatchCentralDifferences) {
  for (const Reduction reduction :
       {Reduction::mean, Reduction::p_norm, Reduction::soft_max, Reduction::maximum,
        Reduction::percentile, Reduction::cvar, Reduction::fraction}) {
    ObjectiveTerm t = term(reduction);
    t.level = 0.6;
    t.limit = 2.5;
    std::vector<double> slopes(kCosts.size());
    reduce(t, kCosts, kUneven, true, slopes.data());
    for (std::size_t i = 0; i < kCosts.size(); ++i) {
      constexpr double kStep = 1e-6;
      std::vector<double> up = kCosts, down = kCosts;
      up[i] += kStep;
      down[i] -= kStep;
      const double difference = (reduce(t, up, kUneven, true, nullptr) -
                                 reduce(t, down, kUneven, true, nullptr)) /
                                (2 * kStep);
      EXPECT_NEAR(slopes[i], difference, 1e-8)
          << static_cast<int>(reduction) << " " << i;
    }
  }
}

}  // namespace
}  // namespace delos::test
