// Properties that any steady-state covariance has, and limits that are known exactly.
#include <gtest/gtest.h>

#include <cmath>

#include "delos/riccati/chain.h"
#include "riccati/long_double.h"
#include "riccati/systems.h"

namespace delos {
namespace {

using testing::Draw;
using testing::embed;
using testing::informed;
using testing::kPrior;
using testing::relative;

/// I_k ⊗ R
Eigen::MatrixXd every_block(const Eigen::MatrixXd& R, int k) {
  const Eigen::Index d = R.rows();
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(k * d, k * d);
  for (int i = 0; i < k; ++i) m.block(i * d, i * d, d, d) = R;
  return m;
}

// Loewner order: P of a system with one more row is below P without it. The slack is
// the rounding of both.
TEST(RiccatiProperty, OneMoreRowNeverHurts) {
  Draw draw(1);
  for (int i = 0; i < 200; ++i) {
    const int n = 2 + i % 6;
    const MotionStep motion{0.7 * draw.matrix(n, n), draw.spd(n)};
    const Eigen::MatrixXd S = draw.spd(n), h = draw.matrix(1, n);
    const SteadyState a = solve_doubling(motion, informed(S));
    const SteadyState b = solve_doubling(motion, informed(S + h.transpose() * h));
    ASSERT_GE(testing::smallest_eigenvalue(a.prior - b.prior), -1e-13 * a.prior.norm());
    ASSERT_GE(testing::smallest_eigenvalue(a.posterior - b.posterior),
              -1e-13 * a.posterior.norm());
    ASSERT_GE(testing::smallest_eigenvalue(a.prior - a.posterior),
              -1e-13 * a.prior.norm());
  }
  for (int i = 0; i < 200; ++i) {
    const CoordinateMatrix L = testing::cholesky(draw.spd(6));
    const Eigen::MatrixXd S = draw.spd(6), h = draw.matrix(1, 6);
    for (int k = 1; k <= 3; ++k) {
      const Sampling sampling{i % 2 == 0, 0.1};
      const auto a = spectral_covariance(spectral_form(L, S), k, sampling, kPrior);
      const auto b = spectral_covariance(spectral_form(L, S + h.transpose() * h), k,
                                         sampling, kPrior);
      ASSERT_GE(testing::smallest_eigenvalue(a - b), -1e-12 * a.norm());
    }
  }
}

// q → c q and R → c R change the unit of variance only.
TEST(RiccatiProperty, VarianceScalesWithBothNoises) {
  Draw draw(2);
  const double c = 3.7;
  for (int k = 1; k <= 3; ++k) {
    const Eigen::MatrixXd q = draw.spd(3), S = draw.spd(3);
    const auto f = spectral_form(testing::cholesky(q), S);
    const auto g = spectral_form(testing::cholesky(c * q), S / c);
    const auto P = spectral_covariance(f, k, {false, 0.1}, kPrior);
    EXPECT_LT(relative(spectral_covariance(g, k, {false, 0.1}, kPrior), c * P), 1e-13);
    const auto step = discretize(testing::chain_model(k, c * q), 0.1);
    EXPECT_LT(
        relative(solve_doubling(step, informed(embed(S / c, 3 * k))).prior, c * P),
        1e-13);
  }
}

// Turning the world turns P.
TEST(RiccatiProperty, RotationIsACongruence) {
  Draw draw(3);
  for (int i = 0; i < 50; ++i) {
    const int d = i % 2 == 0 ? 3 : 6, k = 1 + i % 3;
    const Eigen::MatrixXd q = draw.spd(d), S = draw.spd(d), R = draw.rotation(d);
    const Eigen::MatrixXd all = every_block(R, k);
    const Eigen::MatrixXd turned_q = R * q * R.transpose();
    const Eigen::MatrixXd turned_S = R * S * R.transpose();
    const auto P = spectral_covariance(spectral_form(testing::cholesky(q), S), k,
                                       {false, 0.2}, kPrior);
    const auto T = spectral_covariance(
        spectral_form(testing::cholesky(turned_q), turned_S), k, {false, 0.2}, kPrior);
    EXPECT_LT(relative(T, all * P * all.transpose()), 1e-12);
    const auto step = discretize(testing::chain_model(k, turned_q), 0.2);
    EXPECT_LT(relative(solve_doubling(step, informed(embed(turned_S, d * k))).prior,
                       all * P * all.transpose()),
              1e-12);
  }
}

/// Rows that see the first coordinates of an n-state system.
StateMatrix first_rows(int rows, int n) {
  return StateMatrix(Eigen::MatrixXd::Identity(n, n).topRows(rows));
}

// A perfect position sensor on a P chain: Π = 0 there and P = q dt, whatever happens to
// the other coordinates.
TEST(ExactRows, PerfectPositionLeavesOneStepOfNoise) {
  Draw draw(4);
  const Eigen::MatrixXd q = draw.spd(3);
  const MotionStep step = discretize(testing::chain_model(1, q), 0.4);
  const SteadyState all =
      solve_doubling(step, {StateMatrix::Zero(3, 3), first_rows(3, 3)});
  EXPECT_EQ(all.status, RiccatiStatus::converged);
  EXPECT_LT(relative(all.prior, 0.4 * q), 1e-15);
  EXPECT_LT(all.posterior.norm(), 1e-15);

  const SteadyState one = solve_doubling(step, {draw.spd(3), first_rows(1, 3)});
  EXPECT_NEAR(one.prior(0, 0), 0.4 * q(0, 0), 1e-15);
  EXPECT_LT(one.posterior.row(0).norm(), 1e-15);
}

// R → 0 tends to the exact row, at first order in R.
TEST(ExactRows, AreTheLimitOfSmallNoise) {
  Draw draw(5);
  for (int k = 1; k <= 3; ++k) {
    const Eigen::MatrixXd q = draw.spd(3), others = draw.spd(3);
    const int n = 3 * k;
    const MotionStep step = discretize(testing::chain_model(k, q), 0.4);
    const StateMatrix C = first_rows(1, n);
    const SteadyState exact = solve_doubling(step, {embed(others, n), C});
    ASSERT_EQ(exact.status, RiccatiStatus::converged);
    double last = INFINITY;
    for (double R : {1e-4, 1e-6, 1e-8, 1e-10}) {
      const StateMatrix S = embed(others, n) + C.transpose() * C / R;
      const double difference =
          relative(solve_doubling(step, informed(S)).prior, exact.prior);
      EXPECT_LT(difference, 1e4 * R + 1e-12);
      EXPECT_LT(difference, last / 10 + 1e-12);
      last = difference;
    }
  }
}

// Chains measured perfectly: f_ij at ρ → ∞, where the closed forms have no error left.
TEST(ExactRows, MatchTheChainAtInfiniteInformation) {
  for (int k = 1; k <= 3; ++k) {
    const double dt = 0.7;
    const MotionStep step =
        discretize(testing::chain_model(k, Eigen::MatrixXd::Identity(1, 1)), dt);
    const SteadyState exact =
        solve_doubling(step, {StateMatrix::Zero(k, k), first_rows(1, k)});
    EXPECT_EQ(exact.status, RiccatiStatus::converged);
    EXPECT_LT(relative(exact.prior, discrete_chain(k, dt, 1e30, kPrior).covariance),
              1e-14);
  }
}

TEST(ExactRows, DuplicatesCountOnce) {
  Draw draw(6);
  const MotionStep step = discretize(testing::chain_model(2, draw.spd(3)), 0.1);
  const StateMatrix S = embed(draw.spd(3), 6);
  StateMatrix twice(3, 6);
  twice << first_rows(1, 6), first_rows(1, 6), -2.5 * first_rows(1, 6);
  const SteadyState a = solve_doubling(step, {S, first_rows(1, 6)});
  const SteadyState b = solve_doubling(step, {S, twice});
  EXPECT_EQ(b.status, RiccatiStatus::converged);
  EXPECT_LT(relative(b.prior, a.prior), 1e-14);
  EXPECT_LT((b.posterior - a.posterior).norm(), 1e-14 * a.prior.norm());
}

// Velocity noise only, position read perfectly: x_t − x_{t−1} = v_{t−1} is known, so
// that after an update v has the one-step variance 1 and P = A diag(0, 1) Aᵀ + diag(0,
// 1). The row sees the noise one update late: no doubling map exists.
TEST(ExactRows, ThatSeeTheNoiseLateAreSolvedByRecursion) {
  MotionStep step{StateMatrix(2, 2), StateMatrix(2, 2)};
  step.A << 1, 1, 0, 1;
  step.Q << 0, 0, 0, 1;
  const SteadyState s =
      solve_doubling(step, {StateMatrix::Zero(2, 2), first_rows(1, 2)});
  EXPECT_EQ(s.status, RiccatiStatus::converged);
  Eigen::Matrix2d P;
  P << 1, 1, 1, 2;
  EXPECT_LT(relative(s.prior, P), 1e-13);
  EXPECT_EQ(s.doublings, 0);
}

// A constant bias, measured, without noise: it is learnt for ever, and in the limit the
// filter is the one that knows it.
TEST(NoiseFreeModes, MeasuredConstantIsLearnt) {
  const double dt = 0.1;
  MotionStep step{StateMatrix::Identity(3, 3), StateMatrix::Zero(3, 3)};
  step.A(0, 1) = dt;
  step.Q.topLeftCorner(2, 2) << dt * dt * dt / 3, dt * dt / 2, dt * dt / 2, dt;
  StateMatrix H(2, 3);
  H << 1, 0, 1, 0, 0, 1;  // position + bias, and the bias itself
  const SteadyState s = solve_doubling(step, informed(4 * H.transpose() * H));
  EXPECT_EQ(s.status, RiccatiStatus::converged);
  EXPECT_LT(s.prior.row(2).norm(), 1e-12 * s.prior.norm());
  EXPECT_LT(relative(s.prior.topLeftCorner(2, 2),
                     discrete_chain(2, dt, 4, kPrior).covariance),
            1e-13);
}

// x⁺ = a x without noise, |a| > 1: P = a²P/(1 + sP) has the stabilising root (a² −
// 1)/s.
TEST(NoiseFreeModes, MeasuredGrowthHasAFiniteVariance) {
  for (double a : {1.01, 2.0, -5.0}) {
    MotionStep step{StateMatrix::Constant(1, 1, a), StateMatrix::Zero(1, 1)};
    const SteadyState s =
        solve_doubling(step, informed(StateMatrix::Constant(1, 1, 3)));
    EXPECT_EQ(s.status, RiccatiStatus::converged);
    EXPECT_NEAR(s.prior(0, 0), (a * a - 1) / 3, 1e-12);
    EXPECT_NEAR(testing::closed_loop_radius(step, s), 1 / std::abs(a), 1e-12);
  }
}

// A drift so slow that it shows only after 2³⁰ updates must not be mistaken for none.
// Expected: the scalar chain, k = 1, for the bias alone.
TEST(NoiseFreeModes, MinuteNoiseIsNotNone) {
  MotionStep step{StateMatrix::Identity(2, 2), StateMatrix::Zero(2, 2)};
  step.Q(0, 0) = 1;
  step.Q(1, 1) = 1e-18;
  StateMatrix S = StateMatrix::Identity(2, 2);
  const SteadyState s = solve_doubling(step, informed(S));
  EXPECT_EQ(s.status, RiccatiStatus::converged);
  // q = 1e-18: P = q f(λ q) by scaling the noise to one.
  const double expected = 1e-18 * discrete_chain_variance(1, 1, 1e-18, kPrior);
  EXPECT_NEAR(s.prior(1, 1), expected, 1e-6 * expected);
}

// A perfect position beside noise that drives the velocity alone, which no doubling map
// holds: Π = diag(0, q). With them a walk that is hardly measured, P = (1 + √(1 +
// 4/λ))/2, Π = P/(1 + λP), to which the plain recursion takes some thousand steps.
TEST(RiccatiProperty, PlainRecursionEndsAtTheSteadyState) {
  const double dt = 0.1, a = 0.5, q = 2, lambda = 1e-4;
  MotionStep step{StateMatrix::Identity(3, 3), StateMatrix::Zero(3, 3)};
  step.A(0, 1) = dt;
  step.A(1, 1) = a;
  step.Q(1, 1) = q;
  step.Q(2, 2) = 1;
  Measurement seen{StateMatrix::Zero(3, 3), StateMatrix::Zero(1, 3)};
  seen.information(2, 2) = lambda;
  seen.exact(0, 0) = 1;
  const SteadyState s = solve_doubling(step, seen);
  ASSERT_EQ(s.status, RiccatiStatus::converged);
  const double P = (1 + std::sqrt(1 + 4 / lambda)) / 2;
  EXPECT_NEAR(s.prior(2, 2), P, 1e-11 * P);
  EXPECT_NEAR(s.posterior(2, 2), P / (1 + lambda * P), 1e-11 * P);
  EXPECT_NEAR(s.posterior(1, 1), q, 1e-13 * q);
  EXPECT_NEAR(s.prior(0, 0), dt * dt * q, 1e-13 * q);
}

// The largest state: six coordinates, PVA, twelve drifting biases seen together with
// the pose and by themselves. Reference: doubling in long double.
TEST(LargestState, ThirtyStatesMatchLongDouble) {
  Draw draw(7);
  const int n = kMaxState;
  const MotionStep chain = discretize(testing::chain_model(3, draw.spd(6)), 0.01);
  MotionStep step{StateMatrix::Identity(n, n), StateMatrix::Zero(n, n)};
  step.A.topLeftCorner(18, 18) = chain.A;
  step.Q.topLeftCorner(18, 18) = chain.Q;
  step.Q.diagonal().tail(12).setConstant(1e-6);
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(24, n);
  H.leftCols(6).topRows(12) = draw.matrix(12, 6);
  H.block(0, 18, 12, 12).setIdentity();
  H.block(12, 12, 6, 6).setIdentity();  // accelerometers and the like
  H.block(12, 18, 6, 12) = draw.matrix(6, 12);
  H.block(18, 18, 6, 6).setIdentity();
  const StateMatrix S = 1e3 * H.transpose() * H;
  const SteadyState s = solve_doubling(step, informed(S));
  ASSERT_EQ(s.status, RiccatiStatus::converged);
  const auto reference = testing::long_prior(
      step.A.cast<long double>(), step.Q.cast<long double>(), S.cast<long double>());
  EXPECT_LT(relative(s.prior, reference.cast<double>()), 1e-10);
  EXPECT_LT(riccati_residual(step, informed(S), s.prior), 1e-13);
  EXPECT_LT(testing::closed_loop_radius(step, s), 1);
}

// A cycle of equal steps is that step; a cycle with gaps agrees with its hand-composed
// form.
TEST(Cycle, OfEqualStepsIsTheStep) {
  Draw draw(8);
  const CycleStep step{discretize(testing::chain_model(2, draw.spd(3)), 0.1),
                       informed(embed(draw.spd(3), 6))};
  const SteadyState alone = solve_doubling(step.motion, step.measurement);
  const std::vector<CycleStep> cycle(5, step);
  std::vector<SteadyState> states(5);
  solve_cycle(cycle, states);
  for (const SteadyState& s : states) {
    EXPECT_LT(relative(s.prior, alone.prior), 1e-13);
    EXPECT_LT(relative(s.posterior, alone.posterior), 1e-13);
  }
}

// Sequential updates within one instant (steps of no duration) are one stacked update.
TEST(Cycle, SequentialRowsOfOneInstantAreStacked) {
  Draw draw(9);
  const MotionStep motion = discretize(testing::chain_model(2, draw.spd(3)), 0.1);
  const MotionStep still{StateMatrix::Identity(6, 6), StateMatrix::Zero(6, 6)};
  const StateMatrix a = embed(draw.spd(3), 6), b = embed(draw.spd(3), 6);
  const CycleStep cycle[] = {{motion, informed(a)}, {still, informed(b)}};
  SteadyState states[2];
  solve_cycle(cycle, states);
  const SteadyState stacked = solve_doubling(motion, informed(a + b));
  EXPECT_LT(relative(states[0].prior, stacked.prior), 1e-13);
  EXPECT_LT(relative(states[1].posterior, stacked.posterior), 1e-13);
}

}  // namespace
}  // namespace delos
