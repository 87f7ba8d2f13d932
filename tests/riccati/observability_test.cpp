// Lost directions: which, and that the rest stays finite and right.
#include <gtest/gtest.h>

#include "delos/riccati/chain.h"
#include "riccati/systems.h"

namespace delos {
namespace {

using testing::Draw;
using testing::embed;
using testing::informed;
using testing::kPrior;
using testing::relative;

Eigen::MatrixXd projector(const StateMatrix& basis) {
  return basis * basis.transpose();
}

/// S of rank r: what r random rows tell.
Eigen::MatrixXd rank_deficient(Draw& draw, int d, int r) {
  const Eigen::MatrixXd rows = draw.matrix(r, d);
  return rows.transpose() * rows;
}

class Lost : public ::testing::TestWithParam<std::tuple<int, int>> {};

// All four solvers on chains seen in r < d directions: the same lost subspace, and the
// same covariance of the rest.
TEST_P(Lost, SolversAgree) {
  const auto [d, k] = GetParam();
  const int n = d * k;
  Draw draw(10 * d + k);
  for (int r = 0; r < d; ++r) {
    const Eigen::MatrixXd q = draw.spd(d),
                          S = draw.decades(-2, 3) * rank_deficient(draw, d, r);
    const double dt = draw.decades(-2, 0);
    const SpectralForm form = spectral_form(testing::cholesky(q), S);
    ASSERT_EQ(form.unobservable, d - r);
    const auto model = testing::chain_model(k, q);
    const MotionStep motion = discretize(model, dt);
    const StateMatrix full = embed(S, n);

    const SteadyState s = solve_doubling(motion, informed(full));
    ASSERT_EQ(s.status, RiccatiStatus::unobservable);
    ASSERT_EQ(s.unobservable.cols(), k * (d - r));
    EXPECT_LE((full * s.unobservable).norm(), 1e-12 * full.norm());
    EXPECT_LT((s.unobservable.transpose() * s.unobservable -
               StateMatrix::Identity(k * (d - r), k * (d - r)))
                  .norm(),
              1e-14 * n);
    // The span is that of L u_i in every derivative.
    StateMatrix expected = StateMatrix::Zero(n, k * (d - r));
    for (int i = 0; i < k; ++i)
      expected.block(i * d, i * (d - r), d, d - r) = form.LU.leftCols(d - r);
    const Eigen::MatrixXd away =
        Eigen::MatrixXd::Identity(n, n) - projector(s.unobservable);
    EXPECT_LT((away * expected).norm(), 1e-11 * expected.norm());

    const StateMatrix P = spectral_covariance(form, k, {false, dt}, kPrior);
    const StateMatrix Pi =
        spectral_covariance(form, k, {false, dt}, CovarianceKind::posterior);
    const StateMatrix Pc = spectral_covariance(form, k, {true, 0}, kPrior);
    const double allowed = 1e-10;  // as far as rank decisions to 1e-14 carry over
    EXPECT_LE((s.prior - P).norm(), allowed * P.norm());
    EXPECT_LE((s.posterior - Pi).norm(), allowed * P.norm());
    const CycleStep step{motion, informed(full)};
    const SteadyState vectors = solve_eigenvector({&step, 1});
    EXPECT_EQ(vectors.status, RiccatiStatus::unobservable);
    EXPECT_LE((vectors.prior - P).norm(), 1e-8 * P.norm());
    const SteadyState continuous =
        solve_continuous(continuous_form(model), informed(full));
    EXPECT_EQ(continuous.status, RiccatiStatus::unobservable);
    EXPECT_EQ(continuous.unobservable.cols(), k * (d - r));
    EXPECT_LE((continuous.prior - Pc).norm(), allowed * Pc.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(ChainsAndCoordinates, Lost,
                         ::testing::Combine(::testing::Values(3, 6),
                                            ::testing::Values(1, 2, 3)));

// z unseen and independent of x, y: their covariance is that of a system of two
// coordinates solved alone.
TEST(Lost, RestIsTheSmallerSystem) {
  Draw draw(1);
  for (int k = 1; k <= 3; ++k) {
    Eigen::MatrixXd q = draw.spd(3), S = draw.spd(3);
    q.row(2).head(2).setZero();
    q.col(2).head(2).setZero();
    S.row(2).setZero();
    S.col(2).setZero();
    const auto small =
        solve_doubling(discretize(testing::chain_model(k, q.topLeftCorner(2, 2)), 0.1),
                       informed(embed(S.topLeftCorner(2, 2), 2 * k)));
    ASSERT_EQ(small.status, RiccatiStatus::converged);
    const auto whole = solve_doubling(discretize(testing::chain_model(k, q), 0.1),
                                      informed(embed(S, 3 * k)));
    ASSERT_EQ(whole.unobservable.cols(), k);
    const auto form = spectral_form(testing::cholesky(q), S);
    const auto spectral = spectral_covariance(form, k, {false, 0.1}, kPrior);
    for (const StateMatrix& P : {whole.prior, spectral}) {
      for (int i = 0; i < k; ++i) {
        EXPECT_LT(P.row(3 * i + 2).norm(), 1e-13 * P.norm());
        for (int j = 0; j < k; ++j)
          EXPECT_LT(relative(P.block(3 * i, 3 * j, 2, 2),
                             small.prior.block(2 * i, 2 * j, 2, 2)),
                    1e-12);
      }
    }
  }
}

// The same under continuous measurement, far from the time scale of one second. Entries
// are compared in the units of their own standard deviations.
TEST(Lost, RestIsTheSmallerContinuousSystem) {
  Draw draw(5);
  for (double rate : {1e-24, 1e-8, 1e8, 1e24}) {
    const Eigen::MatrixXd q = Eigen::Vector3d(1, 2, 3).asDiagonal();
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(3, 3);
    S.topLeftCorner(2, 2) = rate * draw.spd(2);
    const auto form = spectral_form(testing::cholesky(q), S);
    const auto expected = spectral_covariance(form, 3, {true, 0}, kPrior);
    const auto whole = solve_continuous(continuous_form(testing::chain_model(3, q)),
                                        informed(embed(S, 9)));
    ASSERT_EQ(whole.unobservable.cols(), 3);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        EXPECT_LT(relative(whole.prior.block(3 * i, 3 * j, 2, 2),
                           expected.block(3 * i, 3 * j, 2, 2)),
                  1e-10);
  }
}

// What is lost moves: the state turns by a quarter between the sensors, of which each
// sees one axis. The direction that is seen each time is a random walk seen by every
// update; the other is never seen, along y after the first step, along x after the
// second.
TEST(Lost, DirectionsFollowTheMotionThroughTheCycle) {
  MotionStep quarter{StateMatrix(2, 2), StateMatrix::Identity(2, 2)};
  quarter.A << 0, -1, 1, 0;
  StateMatrix x = StateMatrix::Zero(2, 2), y = x;
  x(0, 0) = y(1, 1) = 3;
  const CycleStep cycle[] = {{quarter, informed(x)}, {quarter, informed(y)}};
  SteadyState states[2];
  solve_cycle(cycle, states);
  const double expected = discrete_chain_variance(1, 1, 3, kPrior);
  for (int j = 0; j < 2; ++j) {
    EXPECT_EQ(states[j].status, RiccatiStatus::unobservable);
    ASSERT_EQ(states[j].unobservable.cols(), 1);
    EXPECT_NEAR(std::abs(states[j].unobservable(1 - j, 0)), 1, 1e-14);
    EXPECT_NEAR(states[j].prior(j, j), expected, 1e-14);
    EXPECT_NEAR(states[j].prior(1 - j, 1 - j), 0, 1e-14);
  }
}

// A bias that is seen only through the velocity that it drives, in units twelve decades
// off: observability is no matter of units.
TEST(Lost, UnitsDecideNothing) {
  MotionStep step{StateMatrix::Identity(3, 3), StateMatrix::Zero(3, 3)};
  step.A(0, 1) = step.A(1, 2) = 0.1;
  step.Q.diagonal() << 1e-4, 1e-3, 1e-5;
  StateMatrix S = StateMatrix::Zero(3, 3);
  S(0, 0) = 100;
  const SteadyState natural = solve_doubling(step, informed(S));
  ASSERT_EQ(natural.status, RiccatiStatus::converged);
  const Eigen::Vector3d D(1, 1e-6, 1e12), inverse = D.cwiseInverse();
  const MotionStep odd{D.asDiagonal() * step.A * inverse.asDiagonal(),
                       D.asDiagonal() * step.Q * D.asDiagonal()};
  const SteadyState s = solve_doubling(odd, informed(S));
  ASSERT_EQ(s.status, RiccatiStatus::converged);
  const StateMatrix back = inverse.asDiagonal() * s.prior * inverse.asDiagonal();
  EXPECT_LT(relative(back, natural.prior), 1e-12);
}

/// A scalar PV chain, seen or not, with one bias a_b that nothing sees.
SteadyState with_bias(double decay, double bias_noise, double information) {
  const double dt = 0.1;
  const MotionStep chain =
      discretize(testing::chain_model(2, Eigen::MatrixXd::Identity(1, 1)), dt);
  MotionStep step{StateMatrix::Zero(3, 3), StateMatrix::Zero(3, 3)};
  step.A.topLeftCorner(2, 2) = chain.A;
  step.Q.topLeftCorner(2, 2) = chain.Q;
  step.A(2, 2) = decay;
  step.Q(2, 2) = bias_noise;
  StateMatrix S = StateMatrix::Zero(3, 3);
  S(0, 0) = information;
  return solve_doubling(step, informed(S));
}

// A first-order Markov bias has the variance q/(1 − a²) with or without measurements.
TEST(Lost, DecayingBiasKeepsItsFiniteVariance) {
  for (double decay : {0.5, 0.999, 1 - 1e-6}) {
    const SteadyState s = with_bias(decay, 2, 5);
    EXPECT_EQ(s.status, RiccatiStatus::converged);
    EXPECT_NEAR(s.prior(2, 2) * (1 - decay * decay) / 2, 1, 1e-9);
  }
}

TEST(Lost, ConstantOrDriftingBiasIsLostAlone) {
  const auto expected = discrete_chain(2, 0.1, 5, kPrior).covariance;
  for (double noise : {0.0, 2.0}) {
    const SteadyState s = with_bias(1, noise, 5);
    EXPECT_EQ(s.status, RiccatiStatus::unobservable);
    ASSERT_EQ(s.unobservable.cols(), 1);
    EXPECT_NEAR(std::abs(s.unobservable(2, 0)), 1, 1e-14);
    EXPECT_LT(relative(s.prior.topLeftCorner(2, 2), expected), 1e-13);
  }
}

// Nothing seen at all: the chain is lost, a decaying bias is not, however slow.
TEST(Lost, DecayingBiasIsToldFromTheChainBesideIt) {
  for (double decay : {0.5, 1 - 1e-6}) {
    const SteadyState s = with_bias(decay, 2, 0);
    EXPECT_EQ(s.status, RiccatiStatus::unobservable);
    ASSERT_EQ(s.unobservable.cols(), 2);
    EXPECT_LT(s.unobservable.row(2).norm(), 1e-14);
    EXPECT_NEAR(s.prior(2, 2) * (1 - decay * decay) / 2, 1, 1e-9);
    EXPECT_LT(s.prior.topLeftCorner(2, 2).norm(), 1e-13 * s.prior(2, 2));
  }
}

// Position and bias seen only as a sum, the bias constant: their difference is lost as
// long as position has no other dynamics than a random walk.
TEST(Lost, SumOfTwoWalksHidesTheirDifference) {
  const MotionStep step{StateMatrix::Identity(2, 2), StateMatrix::Identity(2, 2)};
  const SteadyState s = solve_doubling(step, informed(StateMatrix::Ones(2, 2)));
  ASSERT_EQ(s.unobservable.cols(), 1);
  EXPECT_NEAR(s.unobservable(0, 0), -s.unobservable(1, 0), 1e-14);
  // Along (1, 1)/√2 it is a walk of noise 1 seen with information 2.
  const double expected = discrete_chain_variance(1, 1, 2, kPrior);
  EXPECT_LT(relative(s.prior, StateMatrix::Constant(2, 2, expected / 2)), 1e-13);
}

TEST(Lost, NothingSeenIsAllLost) {
  Draw draw(2);
  const auto model = testing::chain_model(3, draw.spd(3));
  const StateMatrix none = StateMatrix::Zero(9, 9);
  const CycleStep step{discretize(model, 0.1), informed(none)};
  for (const SteadyState& s : {solve_doubling(step.motion, step.measurement),
                               solve_continuous(continuous_form(model), informed(none)),
                               solve_eigenvector({&step, 1})}) {
    EXPECT_EQ(s.status, RiccatiStatus::unobservable);
    EXPECT_EQ(s.unobservable.cols(), 9);
    EXPECT_LT(s.prior.norm(), 1e-13);
    EXPECT_LT(s.posterior.norm(), 1e-13);
  }
}

// Two sensors take turns, each seeing one direction; a third direction is never seen.
// What is lost is lost at both instants.
TEST(Lost, CycleSeesWhatAnyOfItsStepsSees) {
  Draw draw(3);
  const Eigen::MatrixXd rows = draw.matrix(3, 3);
  const auto model = testing::chain_model(2, draw.spd(3));
  const auto S = [&](int i) {
    return informed(embed(rows.row(i).transpose() * rows.row(i), 6));
  };
  const CycleStep cycle[] = {{discretize(model, 0.1), S(0)},
                             {discretize(model, 0.25), S(1)},
                             {discretize(model, 0.01), S(2)}};
  SteadyState states[3];
  solve_cycle(std::span(cycle).first(2), std::span(states).first(2));
  for (int j = 0; j < 2; ++j) {
    EXPECT_EQ(states[j].status, RiccatiStatus::unobservable);
    ASSERT_EQ(states[j].unobservable.cols(), 2);
    EXPECT_LT((rows.topRows(2) * states[j].unobservable.topRows(3)).norm(), 1e-12);
  }
  solve_cycle(cycle, states);
  for (const SteadyState& s : states) EXPECT_EQ(s.status, RiccatiStatus::converged);
}

// Exact rows see, too.
TEST(Lost, ExactRowsAreSeen) {
  const MotionStep step =
      discretize(testing::chain_model(2, Eigen::MatrixXd::Identity(3, 3)), 0.1);
  const StateMatrix C = StateMatrix(Eigen::MatrixXd::Identity(6, 6).topRows(2));
  const SteadyState s = solve_doubling(step, {StateMatrix::Zero(6, 6), C});
  EXPECT_EQ(s.status, RiccatiStatus::unobservable);
  ASSERT_EQ(s.unobservable.cols(), 2);
  EXPECT_NEAR(projector(s.unobservable)(2, 2) + projector(s.unobservable)(5, 5), 2,
              1e-13);
}

// Weak is not unseen: a billionth of the information is still information.
TEST(Lost, WeaklySeenIsKept) {
  Draw draw(4);
  for (int i = 0; i < 50; ++i) {
    const Eigen::MatrixXd U = draw.rotation(3);
    const Eigen::MatrixXd S =
        U * Eigen::Vector3d(1, 1e-4, 1e-9).asDiagonal() * U.transpose();
    const MotionStep step = discretize(testing::chain_model(3, draw.spd(3)), 0.01);
    EXPECT_EQ(solve_doubling(step, informed(embed((S + S.transpose()) / 2, 9))).status,
              RiccatiStatus::converged);
  }
}

}  // namespace
}  // namespace delos
