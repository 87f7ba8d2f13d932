// Curves along a path: what they take with them, and what is left.
#include "measured/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace delos::measured {
namespace {

std::vector<double> times(int n) {
  std::vector<double> t;
  for (int i = 0; i < n; ++i) t.push_back(3 + 0.02 * i);
  return t;
}

CurveFit fitted(const std::vector<double>& t, const Eigen::MatrixXd& rows, int degree) {
  return std::get<CurveFit>(fit_curve(t, rows, degree));
}

/// The sag of a freely supported rail of length 1 under its own weight and a load that
/// rides along: Roark's table 8.1, cases 2e and 1e at the load.
double sag(double x, double own, double load) {
  return own * (x - 2 * std::pow(x, 3) + std::pow(x, 4)) / 24 +
         load * x * x * (1 - x) * (1 - x) / 3;
}

TEST(Curve, OfTheFourthDegreeIsARailsSag) {
  const auto t = times(200);
  Eigen::MatrixXd rows(200, 1);
  for (int i = 0; i < 200; ++i) rows(i) = sag(i / 199., 0.05, 0.2);
  EXPECT_LT(fitted(t, rows, 4).scatter.norm(), 1e-12);
  EXPECT_GT(fitted(t, rows, 3).deviation()(0), 1e-4);
}

/// Of white noise the deviation is its σ, whatever the degree: by the parameters that
/// the fit takes the sum of squares has fewer degrees, χ² of n − degree − 1.
TEST(Curve, LeavesTheDeviationOfWhiteNoise) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal(0, 0.7e-3);
  for (const int degree : {0, 1, 4, 12}) {
    double squares = 0;
    const int n = 40, runs = 200;
    for (int run = 0; run < runs; ++run) {
      Eigen::MatrixXd rows(n, 2);
      for (int i = 0; i < n; ++i)
        rows.row(i) << 5 + normal(random), -0.2 * i + normal(random);
      const CurveFit fit = fitted(times(n), rows, std::max(1, degree));
      squares += fit.deviation().squaredNorm() / (2 * runs);
      EXPECT_LT((fit.curve + fit.scatter - rows).norm(), 1e-12);
    }
    const double error = 0.49e-6 * std::sqrt(2. / (2 * runs * (n - degree - 1)));
    EXPECT_NEAR(squares, 0.49e-6, 4 * error) << degree;
  }
}

/// The degree as published: before the rail's sag was taken away measured and
/// calculated were "an order of magnitude" apart. 5.03 mm of sag and 0.7 mm of noise.
TEST(Curve, TellsSagFromScatter) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0, 0.7e-3);
  Eigen::MatrixXd rows(500, 1);
  const double scale = 5.03e-3 / sag(0.5, 0, 1);
  for (int i = 0; i < 500; ++i) rows(i) = scale * sag(i / 499., 0, 1) + normal(random);
  EXPECT_NEAR(fitted(times(500), rows, 4).deviation()(0), 0.7e-3, 0.1e-3);
  EXPECT_GT(fitted(times(500), rows, 1).deviation()(0), 1.5e-3);
}

TEST(Curve, RefusesTooFewPlaces) {
  const auto refused = [](int n, int degree) {
    return std::holds_alternative<std::string>(
        fit_curve(times(n), Eigen::MatrixXd::Zero(n, 3), degree));
  };
  EXPECT_TRUE(refused(5, 4));
  EXPECT_FALSE(refused(6, 4));
  EXPECT_TRUE(std::holds_alternative<std::string>(
      fit_curve({1, 1, 1}, Eigen::MatrixXd::Zero(3, 1), 1)));
}

}  // namespace
}  // namespace delos::measured
