// Four independent solvers on the same random systems, against a long-double reference.
//
// Bounds. P is a function of M = LᵀSL. Forming M in double (two products of d terms)
// moves λmin by 2 d ε ‖M‖, and f(λ) ~ λ^−p with p < 1 by less, relatively; the doubling
// forms QS, factors I + QS and multiplies three times, 8 d ε. So no solver can be asked
// for more than
//
//     ‖ΔP‖/‖P‖ ≤ c d ε cond(M),  c = 2 (spectral), 8 (all others).
//
// SLICOT and the eigenvectors of Ψ also carry an error of their own, which grows with n
// and with how slowly the filter forgets. It needs no guess: for an approximate X with
// residual R = A (X⁻¹ + S)⁻¹ Aᵀ + Q − X, one Newton step says X is wrong by E = Σ_t F^t
// R (F^t)ᵀ. A solver is held to the first of 1e-9, c d ε cond(M), 2‖E‖ that it meets;
// the counts are printed. The kernel's spectral and doubling solvers are held to the
// first two only.
//
// Eigenvectors have a limit besides. For ρ → 0, Ψ of a chain tends to a Jordan block of
// order 2k at 1, whose eigenvalues rounding moves by (n ε)^(1/2k): where the closed
// loop's poles are not ten times farther inside the circle, they cannot be told from
// their mirror images outside, and the method is not asked.
#include <gtest/gtest.h>

#include <cstdio>

#include "riccati/long_double.h"
#include "riccati/slicot.h"
#include "riccati/systems.h"

namespace delos {
namespace {

using testing::Draw;
using testing::kEps;
using testing::LongMatrix;

/// ‖E‖/‖X‖ of the comment above.
double newton_error(const MotionStep& motion, const StateMatrix& S,
                    const Eigen::MatrixXd& approximate) {
  const LongMatrix A = motion.A.cast<long double>(),
                   X = approximate.cast<long double>();
  const LongMatrix I = LongMatrix::Identity(X.rows(), X.cols());
  const LongMatrix kept = (I + X * S.cast<long double>()).inverse();
  LongMatrix F = A * kept;
  LongMatrix E = A * kept * X * A.transpose() + motion.Q.cast<long double>() - X;
  for (int i = 0; i < 40; ++i) {
    E += (F * E * F.transpose()).eval();
    F = (F * F).eval();
  }
  return static_cast<double>(E.norm() / X.norm());
}

/// How many cases of one solver were held to which bound.
struct Tally {
  const char* solver;
  int strict = 0, conditioned = 0, own = 0;
  double worst = 0;

  /// @param newton ‖E‖, a function since it is rarely needed
  template <class Newton>
  void count(double error, double conditioning, Newton newton) {
    worst = std::max(worst, error);
    if (error <= 1e-9) {
      ++strict;
    } else if (error <= conditioning) {
      ++conditioned;
    } else {
      ++own;
      EXPECT_LE(error, 2 * newton()) << solver;
    }
  }
  void print(int d, int k) const {
    std::printf(
        "d=%d k=%d %-12s 1e-9: %4d  c·d·eps·cond: %4d  own residual: %4d  worst %.1e\n",
        d, k, solver, strict, conditioned, own, worst);
  }
};

class Differential : public ::testing::TestWithParam<std::tuple<int, int>> {};

TEST_P(Differential, ThousandSystems) {
  const auto [d, k] = GetParam();
  const int n = d * k;
  Draw draw(100 * d + k);
  testing::Slicot slicot(n);
  Tally spectral{"spectral"}, doubling{"doubling"}, eigenvector{"eigenvector"},
      sb02od{"SB02OD"};
  const auto none = [] { return 0.0; };
  int solved = 0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::MatrixXd q = draw.spd(d, -0.5, 0.5);
    const Eigen::MatrixXd S =
        draw.decades(-2, 4) * draw.spd(d, -draw.uniform(0, 12), 0);
    const double dt = draw.decades(-3, -1);
    const CoordinateMatrix L = testing::cholesky(q);
    const double unit = d * kEps * testing::condition(L.transpose() * S * L);
    const MotionStep motion = discretize(testing::chain_model(k, q), dt);
    const StateMatrix full = testing::embed(S, n);
    const Eigen::MatrixXd reference =
        testing::long_prior(motion.A.cast<long double>(), motion.Q.cast<long double>(),
                            full.cast<long double>())
            .cast<double>();

    const SpectralForm form = spectral_form(L, S);
    ASSERT_EQ(form.unobservable, 0) << "case " << i;
    spectral.count(testing::relative(
                       spectral_covariance(form, k, {false, dt}, CovarianceKind::prior),
                       reference),
                   2 * unit, none);
    const SteadyState state = solve_doubling(motion, testing::informed(full));
    ASSERT_EQ(state.status, RiccatiStatus::converged) << "case " << i;
    doubling.count(testing::relative(state.prior, reference), 8 * unit, none);

    if (1 - testing::closed_loop_radius(motion, state) >
        10 * std::pow(n * kEps, 0.5 / k)) {
      const CycleStep step{motion, testing::informed(full)};
      const SteadyState vectors = solve_eigenvector({&step, 1});
      EXPECT_EQ(vectors.status, RiccatiStatus::converged);
      eigenvector.count(testing::relative(vectors.prior, reference), 8 * unit,
                        [&] { return newton_error(motion, full, vectors.prior); });
    }
    const testing::SlicotResult other = slicot.sb02od(motion.A, motion.Q, full);
    if (other.info != 0) continue;
    ++solved;
    sb02od.count(testing::relative(other.P, reference), 8 * unit,
                 [&] { return newton_error(motion, full, other.P); });
  }
  EXPECT_GE(solved, 990) << "SLICOT gave up on the rest";
  for (const Tally& tally : {spectral, doubling, eigenvector, sb02od})
    tally.print(d, k);
}

// The posterior: the two own solvers against (I + PS)⁻¹P in long double.
TEST_P(Differential, Posteriors) {
  const auto [d, k] = GetParam();
  Draw draw(200 * d + k);
  for (int i = 0; i < 100; ++i) {
    const Eigen::MatrixXd q = draw.spd(d), S = draw.decades(-2, 4) * draw.spd(d, -2, 2);
    const double dt = draw.decades(-3, 0);
    const CoordinateMatrix L = testing::cholesky(q);
    const MotionStep motion = discretize(testing::chain_model(k, q), dt);
    const StateMatrix full = testing::embed(S, d * k);
    const LongMatrix P =
        testing::long_prior(motion.A.cast<long double>(), motion.Q.cast<long double>(),
                            full.cast<long double>());
    const Eigen::MatrixXd reference =
        testing::long_posterior(P, full.cast<long double>()).cast<double>();
    const double bound = 8 * d * kEps * testing::condition(L.transpose() * S * L);
    EXPECT_LT(testing::relative(
                  solve_doubling(motion, testing::informed(full)).posterior, reference),
              1e-12 + bound);
    EXPECT_LT(testing::relative(spectral_covariance(spectral_form(L, S), k, {false, dt},
                                                    CovarianceKind::posterior),
                                reference),
              1e-12 + bound);
  }
}

// Continuous measurement: spectral, doubling after the Cayley transform, and SB02OD.
TEST_P(Differential, ContinuousMeasurement) {
  const auto [d, k] = GetParam();
  Draw draw(300 * d + k);
  testing::Slicot slicot(d * k);
  for (int i = 0; i < 200; ++i) {
    const Eigen::MatrixXd q = draw.spd(d), S = draw.decades(-2, 6) * draw.spd(d, -2, 2);
    const CoordinateMatrix L = testing::cholesky(q);
    const MotionStep motion = continuous_form(testing::chain_model(k, q));
    const StateMatrix full = testing::embed(S, d * k);
    const double bound =
        1e-12 + 2 * d * kEps * testing::condition(L.transpose() * S * L);
    const SteadyState state = solve_continuous(motion, testing::informed(full));
    ASSERT_EQ(state.status, RiccatiStatus::converged);
    const StateMatrix spectral =
        spectral_covariance(spectral_form(L, S), k, {true, 0}, CovarianceKind::prior);
    ASSERT_LT(testing::relative(state.prior, spectral), bound) << "case " << i;
    const testing::SlicotResult other = slicot.sb02od(motion.A, motion.Q, full, true);
    ASSERT_EQ(other.info, 0);
    ASSERT_LT(testing::relative(other.P, spectral), 1e-9 + bound) << "case " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(ChainsAndCoordinates, Differential,
                         ::testing::Combine(::testing::Values(3, 6),
                                            ::testing::Values(1, 2, 3)));

}  // namespace
}  // namespace delos
