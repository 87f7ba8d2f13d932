// The chain whose readings take time, against a filter that integrates them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "delos/riccati/chain.h"
#include "riccati/systems.h"
#include "support/exposing_filter.h"

namespace delos {
namespace {

using testing::ExposingFilter;
using testing::kPosterior;
using testing::kPrior;
using testing::LongMatrix;

constexpr double kTick = 0.001;  // s
constexpr int kPeriod = 20;      // ticks

ExposingFilter filter_of(int order, int exposure, double lambda) {
  const LongMatrix one = LongMatrix::Ones(1, 1);
  return {order, one, kTick, {{kPeriod, exposure, 0, one, one / lambda}}};
}

double largest_error(const ChainMatrix& a, const LongMatrix& reference) {
  return static_cast<double>((a.cast<long double>() - reference)
                                 .cwiseQuotient(reference)
                                 .cwiseAbs()
                                 .maxCoeff());
}

class ExposedChain : public ::testing::TestWithParam<int> {};  // the order k

/// Expected: the filter, which needs h, R_η and N nowhere.
TEST_P(ExposedChain, IsThatOfAFilterWithTheIntegralAsAState) {
  const int k = GetParam();
  const double dt = kTick * kPeriod;
  double worst = 0;
  for (const int exposure : {5, 13, 20})
    for (const double rho : {1e-4, 1e-2, 1.0, 1e2, 1e5}) {
      const double lambda = rho / std::pow(dt, 2 * k - 1), tau = exposure * kTick;
      const ExposingFilter filter = filter_of(k, exposure, lambda);
      const ChainMatrix P = exposed_chain(k, dt, tau, lambda, kPrior).covariance;
      const ChainMatrix Pi = exposed_chain(k, dt, tau, lambda, kPosterior).covariance;
      const double error = std::max(largest_error(P, filter.prior.front()),
                                    largest_error(Pi, filter.posterior.front()));
      worst = std::max(worst, error);
      EXPECT_LT(error, 1e-10) << exposure << " of 20, rho " << rho;
      const double constant = static_cast<double>(-dt / std::log(filter.radius));
      EXPECT_NEAR(exposed_chain_time_constant(k, dt, tau, lambda), constant,
                  1e-9 * constant);
    }
  RecordProperty("worst", std::to_string(worst * 1e15) + "e-15");
}

TEST_P(ExposedChain, WithoutExposureIsTheSameToTheLastBit) {
  const int k = GetParam();
  for (const double lambda : {1e-3, 1.0, 1e7})
    for (const CovarianceKind kind : {kPrior, kPosterior}) {
      const auto now = exposed_chain_with_derivative(k, 0.03, 0, lambda, kind);
      const auto then = discrete_chain_with_derivative(k, 0.03, lambda, kind);
      EXPECT_EQ(now.covariance, then.covariance);
      EXPECT_EQ(now.derivative, then.derivative);
      EXPECT_EQ(exposed_chain_time_constant(k, 0.03, 0, lambda),
                discrete_chain_time_constant(k, 0.03, lambda));
    }
}

/// A moment's exposure changes a moment's part, and few digits are lost on the way
/// there, however good the readings are, or bad: doubling errs by ε for each update
/// that the filter remembers, a million of them at the worst here.
TEST_P(ExposedChain, TendsToThatOfOneInstant) {
  const int k = GetParam();
  for (const double rho : {1e-12, 1e-3, 1.0, 1e6})
    for (const CovarianceKind kind : {kPrior, kPosterior}) {
      const ChainMatrix limit = discrete_chain(k, 1, rho, kind).covariance;
      const ChainMatrix near =
          exposed_chain(k, 1, 1e-13 / (1 + rho), rho, kind).covariance;
      EXPECT_LT(largest_error(near, limit.cast<long double>()), 2e-11) << rho;
    }
}

/// Expected: central differences of f, which errs by h² and 1e-13/h.
TEST_P(ExposedChain, SlopesAreDifferences) {
  const int k = GetParam();
  for (const double tau : {0.1, 0.65, 1.0})
    for (const double rho : {1e-6, 1e-2, 1.0, 1e2})
      for (const CovarianceKind kind : {kPrior, kPosterior}) {
        const double h = 1e-4 * rho;
        const ChainMatrix up = exposed_chain(k, 1, tau, rho + h, kind).covariance,
                          down = exposed_chain(k, 1, tau, rho - h, kind).covariance;
        const ChainMatrix slope =
            exposed_chain_with_derivative(k, 1, tau, rho, kind).derivative;
        EXPECT_LT((slope - (up - down) / (2 * h)).norm(), 1e-7 * slope.norm())
            << tau << " " << rho;
      }
}

INSTANTIATE_TEST_SUITE_P(Order, ExposedChain, ::testing::Values(1, 2, 3));

/// Expected: 100,000 targets that move, and the filter of the printed gain
/// K = (P hᵀ + N)/(h P hᵀ + 2 h N + R + R_η) after each: the mean square of its errors,
/// within four times that mean's standard deviation, √(2/n) of it. Positions are moved
/// in 16 steps a window, each exactly, and read by the trapezoid rule, whose error is a
/// thousandth of a step's noise.
TEST(ExposedPaths, ErrAsMuchAsIsSaid) {
  constexpr int kPaths = 100'000, kUpdates = 5, kSteps = 16;
  const double dt = 1, tau = 0.65, lambda = 3;
  const ChainMatrix P = exposed_chain(2, dt, tau, lambda, kPrior).covariance;
  const ChainMatrix Pi = exposed_chain(2, dt, tau, lambda, kPosterior).covariance;
  const Eigen::RowVector2d h(1, -tau / 2);
  const Eigen::Vector2d N(tau * tau * tau / 24, tau * tau / 6);
  const double R_eta = tau * tau * tau / 20;
  const Eigen::Vector2d K = (P * h.transpose() + N) /
                            (h.dot(P * h.transpose()) + 2 * h * N + R_eta + 1 / lambda);

  std::mt19937_64 random(22);
  std::normal_distribution<double> normal;
  // w of δ seconds: var δ³/3 of the position, whose part δ²/2 the velocity shares.
  const auto move = [&](Eigen::Vector2d& x, double delta) {
    const double a = normal(random), b = normal(random), root = std::sqrt(delta);
    x[0] += delta * x[1] + delta * root * (a / 2 + b / std::sqrt(12.0));
    x[1] += root * a;
  };
  Eigen::Matrix2d before = Eigen::Matrix2d::Zero(), after = before;
  for (int path = 0; path < kPaths; ++path) {
    // From an error of the steady state, so that it stays one.
    const Eigen::Matrix2d root = Eigen::Matrix2d(Pi).llt().matrixL();
    Eigen::Vector2d x = root * Eigen::Vector2d(normal(random), normal(random));
    Eigen::Vector2d estimate = Eigen::Vector2d::Zero(), error_before;
    for (int update = 0; update < kUpdates; ++update) {
      move(x, dt - tau);
      double mean = x[0] / 2;
      for (int step = 0; step < kSteps; ++step) {
        move(x, tau / kSteps);
        mean += step + 1 < kSteps ? x[0] : x[0] / 2;
      }
      const double z = mean / kSteps + normal(random) / std::sqrt(lambda);
      estimate[0] += dt * estimate[1];
      error_before = x - estimate;
      estimate += K * (z - h * estimate);
    }
    before += error_before * error_before.transpose();
    after += (x - estimate) * (x - estimate).transpose();
  }
  before /= kPaths, after /= kPaths;
  const double slack = 4 * std::sqrt(2.0 / kPaths);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(before(i, i), P(i, i), slack * P(i, i));
    EXPECT_NEAR(after(i, i), Pi(i, i), slack * Pi(i, i));
  }
  // A filter of instants would be said to be better or worse than that by more.
  EXPECT_GT(
      std::abs(discrete_chain(2, dt, lambda, kPrior).covariance(0, 0) / P(0, 0) - 1),
      2 * slack);
}

}  // namespace
}  // namespace delos
