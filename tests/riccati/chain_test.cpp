// The chain's closed forms against long-double references, published gains and limits.
#include "delos/riccati/chain.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "riccati/long_double.h"
#include "riccati/systems.h"

namespace delos {
namespace {

using testing::kPosterior;
using testing::kPrior;
using testing::long_posterior;
using testing::long_prior;
using testing::LongChain;
using testing::LongMatrix;

/// Largest relative error of any entry.
double entrywise(const ChainMatrix& a, const LongMatrix& reference) {
  return static_cast<double>((a.cast<long double>() - reference)
                                 .cwiseQuotient(reference)
                                 .cwiseAbs()
                                 .maxCoeff());
}

class Chain : public ::testing::TestWithParam<int> {};  // the order k

// Expected: doubling in long double. Its own error grows with ρ in the posterior, which
// it gets as (I + PS)⁻¹P: the bound is its rounding, 2^−64 ρ, where that exceeds the
// kernel's.
TEST_P(Chain, MatchesLongDoubleDoublingOver24Decades) {
  const int k = GetParam();
  double worst = 0;
  for (double dt : {1.0, 0.01}) {
    for (double exponent = -12; exponent <= 12; exponent += 0.25) {
      const double lambda = std::pow(10, exponent) / std::pow(dt, 2 * k - 1);
      const LongChain c(k, dt, lambda);
      const LongMatrix P = long_prior(c.A, c.Q, c.S);
      const double prior =
          entrywise(discrete_chain(k, dt, lambda, kPrior).covariance, P);
      worst = std::max(worst, prior);
      ASSERT_LT(prior, 1e-13) << "rho = 1e" << exponent;
      const double posterior = entrywise(
          discrete_chain(k, dt, lambda, kPosterior).covariance, long_posterior(P, c.S));
      ASSERT_LT(posterior, 1e-13 + 1e-18 * std::pow(10, exponent))
          << "rho = 1e" << exponent;
    }
  }
  RecordProperty("worst_prior_error", std::to_string(worst * 1e16) + "e-16");
}

// The definition itself, P = A Π Aᵀ + Q and Π⁻¹ = P⁻¹ + S, where no other solver is
// left to compare with. Tolerance: entries are rounded to double, each equation sums at
// most nine.
TEST_P(Chain, SolvesItsEquationAtTheExtremes) {
  const int k = GetParam();
  for (double exponent : {-30.0, -20.0, -12.0, 12.0, 20.0, 30.0}) {
    const double dt = 0.1, lambda = std::pow(10, exponent) / std::pow(dt, 2 * k - 1);
    const LongChain c(k, dt, lambda);
    const LongMatrix P =
        discrete_chain(k, dt, lambda, kPrior).covariance.cast<long double>();
    const LongMatrix Pi =
        discrete_chain(k, dt, lambda, kPosterior).covariance.cast<long double>();
    const LongMatrix predicted = c.A * Pi * c.A.transpose() + c.Q;
    EXPECT_LT(double((predicted - P).cwiseQuotient(P).cwiseAbs().maxCoeff()), 1e-15 * 9)
        << "prediction, rho = 1e" << exponent;
    // Π_0j = P_0j/(1 + λP_00)
    const LongMatrix row = P.row(0) / (1 + lambda * P(0, 0));
    EXPECT_LT(double((row - Pi.row(0)).cwiseQuotient(row).cwiseAbs().maxCoeff()),
              1e-15 * 4)
        << "correction, rho = 1e" << exponent;
    // The root is the stabilising one: P > 0 decides, for others are indefinite.
    Eigen::LLT<Eigen::MatrixXd> positive(P.cast<double>());
    EXPECT_EQ(positive.info(), Eigen::Success);
  }
}

// Kalata (1984), "The tracking index", IEEE Trans. AES-20(2), 174–182, for the chain
// driven by white noise of density q: his α-β relation α = √(2β) + β/... is replaced by
// the exact one of this process noise, u-form of docs/theory.md §2: β = 12/(6(u + √u) +
// 1), α = β√u.
TEST(ChainGains, AreKalatasForConstantVelocity) {
  for (double rho : {1e-6, 1e-3, 0.1, 1.0, 10.0, 1e4}) {
    const double dt = 0.02, lambda = rho / std::pow(dt, 3);
    const double u = 1.0 / 3 + std::sqrt(1.0 / 12 + 4 / rho);
    const double beta = 12 / (6 * (u + std::sqrt(u)) + 1), alpha = beta * std::sqrt(u);
    const ChainMatrix Pi = discrete_chain(2, dt, lambda, kPosterior).covariance;
    EXPECT_NEAR(Pi(0, 0) * lambda, alpha, 1e-14 * alpha);  // K = Π Hᵀ R⁻¹
    EXPECT_NEAR(Pi(1, 0) * lambda * dt, beta, 1e-14 * beta);
  }
}

// Expected: central differences of the long-double reference; step 1e-4 and
// Richardson's extrapolation leave h⁴ ~ 1e-15 and rounding 2^−64/h. Towards large ρ the
// differences cancel (f tends to a constant), so that the comparison stops at ρ = 1e3.
TEST_P(Chain, DerivativeMatchesDifferences) {
  const int k = GetParam();
  for (double exponent = -12; exponent <= 3; exponent += 0.5) {
    const long double dt = 0.5L, lambda = std::pow(10.0L, exponent);
    const auto f = [&](long double x, CovarianceKind kind) -> LongMatrix {
      const LongChain c(k, dt, x);
      const LongMatrix P = long_prior(c.A, c.Q, c.S);
      return kind == kPrior ? P : long_posterior(P, c.S);
    };
    for (CovarianceKind kind : {kPrior, kPosterior}) {
      const long double h = 1e-4L * lambda;
      const LongMatrix slope = (8 * (f(lambda + h, kind) - f(lambda - h, kind)) -
                                (f(lambda + 2 * h, kind) - f(lambda - 2 * h, kind))) /
                               (12 * h);
      const auto solution = discrete_chain_with_derivative(
          k, static_cast<double>(dt), static_cast<double>(lambda), kind);
      const double reference = 1e-15 * std::pow(10, -exponent / (2 * k));
      ASSERT_LT(entrywise(solution.derivative, slope), 2e-11 + reference)
          << "rho = 1e" << exponent;
    }
  }
}

// Implicit differentiation of P = A Π Aᵀ + Q: dP = F dP Fᵀ − A Π e₀ e₀ᵀ Π Aᵀ dλ with
// F = A (I + PS)⁻¹ must hold for the derivative at any ρ, large ones included; and
// dP = A dΠ Aᵀ.
TEST_P(Chain, DerivativeSolvesItsSteinEquation) {
  const int k = GetParam();
  for (double exponent = -12; exponent <= 12; exponent += 0.5) {
    const double lambda = std::pow(10, exponent);
    const LongMatrix A = LongChain(k, 1, lambda).A;
    const auto prior = discrete_chain_with_derivative(k, 1, lambda, kPrior);
    const auto posterior = discrete_chain_with_derivative(k, 1, lambda, kPosterior);
    const LongMatrix P = prior.covariance.cast<long double>();
    const LongMatrix dP = prior.derivative.cast<long double>();
    const LongMatrix dPi = posterior.derivative.cast<long double>();
    // (I + PS)⁻¹ = I − P e₀ e₀ᵀ λ/(1 + λP_00), whose corner is 1/(1 + λP_00).
    const long double innovation = 1 + lambda * P(0, 0);
    LongMatrix kept = LongMatrix::Identity(k, k);
    kept.col(0) -= P.col(0) * (lambda / innovation);
    kept(0, 0) = 1 / innovation;
    const LongMatrix F = A * kept, pushed = A * P.col(0) / innovation;
    const LongMatrix stein = F * dP * F.transpose() - pushed * pushed.transpose();
    ASSERT_LT(double((stein - dP).norm() / dP.norm()), 1e-13) << "rho = 1e" << exponent;
    const LongMatrix predicted = A * dPi * A.transpose();
    ASSERT_LT(double((predicted - dP).norm() / dP.norm()), 1e-13)
        << "rho = 1e" << exponent;
  }
}

TEST_P(Chain, VarianceAloneIsTheSame) {
  const int k = GetParam();
  for (double lambda : {1e-9, 1.0, 1e7})
    for (CovarianceKind kind : {kPrior, kPosterior})
      EXPECT_EQ(discrete_chain_variance(k, 0.03, lambda, kind),
                discrete_chain(k, 0.03, lambda, kind).covariance(0, 0));
}

// dt → 0 at constant information per second is continuous measurement; the difference
// is O(dt/τ), and prior and posterior lie on both sides.
TEST_P(Chain, TendsToContinuousMeasurement) {
  const int k = GetParam();
  const double rate = 50, dt = 1e-9;
  const ChainMatrix limit = continuous_chain(k, rate).covariance;
  const ChainMatrix P = discrete_chain(k, dt, rate * dt, kPrior).covariance;
  const ChainMatrix Pi = discrete_chain(k, dt, rate * dt, kPosterior).covariance;
  for (int i = 0; i < k; ++i) {
    for (int j = 0; j < k; ++j) {
      EXPECT_NEAR(P(i, j), limit(i, j), 1e-7 * limit(i, j));
      EXPECT_GT(P(i, j), limit(i, j));
      EXPECT_LT(Pi(i, j), limit(i, j));
    }
  }
}

// F P + P Fᵀ + e e ᵀ = λ P e₀ e₀ᵀ P, entry by entry, and its derivative.
TEST_P(Chain, ContinuousFormSolvesItsEquation) {
  const int k = GetParam();
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(k, k), Q = F;
  for (int i = 0; i + 1 < k; ++i) F(i, i + 1) = 1;
  Q(k - 1, k - 1) = 1;
  for (double rate : {1e-6, 0.3, 1.0, 1e8}) {
    const auto [P, dP] = continuous_chain_with_derivative(k, rate);
    const Eigen::MatrixXd used = rate * P.col(0) * P.row(0);
    const Eigen::MatrixXd gained = F * P + P * F.transpose() + Q;
    for (int i = 0; i < k; ++i)
      for (int j = 0; j < k; ++j)
        EXPECT_NEAR(gained(i, j), used(i, j), 1e-14 * used(i, j));
    const Eigen::MatrixXd derived = F * dP + dP * F.transpose() - P.col(0) * P.row(0) -
                                    rate * dP.col(0) * P.row(0) -
                                    rate * P.col(0) * dP.row(0);
    EXPECT_LT(derived.norm(), 1e-14 * (P.col(0) * P.row(0)).norm());
  }
}

// Expected: eigenvalues of A − KH = A (I + PS)⁻¹ in double, good to 1e-12 while the
// poles stay well inside the circle.
TEST_P(Chain, TimeConstantIsThatOfTheClosedLoop) {
  const int k = GetParam();
  for (double rho : {1e-4, 0.01, 1.0, 30.0, 200.0, 1e5}) {
    const double dt = 0.25, lambda = rho / std::pow(dt, 2 * k - 1);
    const LongChain c(k, dt, lambda);
    const LongMatrix P = long_prior(c.A, c.Q, c.S);
    const LongMatrix I = LongMatrix::Identity(k, k);
    const LongMatrix F = c.A * (I + P * c.S).inverse();
    const long double radius =
        Eigen::EigenSolver<LongMatrix>(F).eigenvalues().cwiseAbs().maxCoeff();
    const double expected = static_cast<double>(-dt / std::log(radius));
    EXPECT_NEAR(discrete_chain_time_constant(k, dt, lambda), expected, 1e-10 * expected)
        << "rho = " << rho;
  }
}

TEST_P(Chain, ContinuousTimeConstantIsThatOfTheClosedLoop) {
  const int k = GetParam();
  const double rate = 7;
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(k, k);
  for (int i = 0; i + 1 < k; ++i) F(i, i + 1) = 1;
  F.col(0) -= rate * continuous_chain(k, rate).covariance.col(0);  // F − P Hᵀ R⁻¹ H
  const double slowest =
      Eigen::EigenSolver<Eigen::MatrixXd>(F).eigenvalues().real().maxCoeff();
  EXPECT_NEAR(continuous_chain_time_constant(k, rate), -1 / slowest, 1e-13 / -slowest);
}

INSTANTIATE_TEST_SUITE_P(Order, Chain, ::testing::Values(1, 2, 3));

}  // namespace
}  // namespace delos
