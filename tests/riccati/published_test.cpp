// Published solutions, and the table of fusion modes of docs/theory.md §4.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "delos/riccati/chain.h"
#include "delos/riccati/cycle.h"
#include "riccati/systems.h"

namespace delos {
namespace {

using testing::chain_model;
using testing::informed;

// P. Benner, A. Laub, V. Mehrmann, "A Collection of Benchmark Examples for the
// Numerical Solution of Algebraic Riccati Equations II: Discrete-Time Case", SPC 95_23,
// TU Chemnitz, 1995. Those examples whose exact X is given. They are control problems:
// F = Aᵀ.
struct Darex {
  const char* name;
  Eigen::MatrixXd A, B, Q, R, X;
  double tolerance;  // relative, Frobenius: what double precision allows here
};

void PrintTo(const Darex& d, std::ostream* os) { *os << d.name; }

Eigen::MatrixXd M(int rows, int cols, std::initializer_list<double> values) {
  Eigen::MatrixXd m(rows, cols);
  auto it = values.begin();
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < cols; ++c) m(r, c) = *it++;
  return m;
}

Darex shift_chain(int n) {  // Example 2.4 at order n; X = diag(1, …, n)
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n), B = Eigen::MatrixXd::Zero(n, 1),
                  X = A;
  for (int i = 0; i + 1 < n; ++i) A(i, i + 1) = 1;
  B(n - 1, 0) = 1;
  for (int i = 0; i < n; ++i) X(i, i) = i + 1;
  return {"shift_chain", A, B, Eigen::MatrixXd::Identity(n, n), M(1, 1, {1}), X, 1e-14};
}

std::vector<Darex> darex() {
  const double phi = (1 + std::sqrt(5.0)) / 2, e = 1e6;
  return {{"example_1", M(2, 2, {4, 3, -4.5, -3.5}), M(2, 1, {1, -1}),
           M(2, 2, {9, 6, 6, 4}), M(1, 1, {1}), phi * M(2, 2, {9, 6, 6, 4}), 1e-13},
          {"example_5", M(2, 2, {0, 1, 0, 0}), M(2, 1, {0, 1}), M(2, 2, {1, 2, 2, 4}),
           M(1, 1, {1}), M(2, 2, {1, 2, 2, 2 + std::sqrt(5.0)}), 1e-14},
          {"example_12", M(2, 2, {0, e, 0, 0}), M(2, 1, {0, 1}), M(2, 2, {1, 0, 0, 1}),
           M(1, 1, {1}), M(2, 2, {1, 0, 0, 1 + e * e}), 1e-14},
          shift_chain(8)};
}

class PublishedDarex : public ::testing::TestWithParam<Darex> {};

TEST_P(PublishedDarex, IsReproduced) {
  const Darex& d = GetParam();
  const Eigen::MatrixXd S = d.B * d.R.inverse() * d.B.transpose();
  const MotionStep motion{d.A.transpose(), d.Q};
  const SteadyState s = solve_doubling(motion, informed(S));
  EXPECT_EQ(s.status, RiccatiStatus::converged);
  EXPECT_LT(testing::relative(s.prior, d.X), d.tolerance) << s.prior;
  EXPECT_LT(riccati_residual(motion, informed(S), s.prior), d.tolerance);
  const CycleStep step{motion, informed(S)};
  EXPECT_LT(closed_loop_radius({&step, 1}, {&s, 1}), 1);
}

INSTANTIATE_TEST_SUITE_P(Examples, PublishedDarex, ::testing::ValuesIn(darex()),
                         [](const auto& i) { return i.param.name; });

// Kalata (1984), "The tracking index: a generalized parameter for α-β and α-β-γ target
// trackers", IEEE Trans. AES-20(2), 174–182: the steady gain of a constant-velocity
// filter with piecewise constant acceleration depends on λ = σ_a T²/σ_z alone.
TEST(Published, TrackingIndexGivesKalatasAlpha) {
  for (const double lambda : {0.01, 0.1, 0.5, 1.0, 2.0, 10.0}) {
    const double T = 0.01, sigma_z = 1e-3, sigma_a = lambda * sigma_z / (T * T);
    const double r = (4 + lambda - std::sqrt(8 * lambda + lambda * lambda)) / 4;
    const double alpha = 1 - r * r;
    const Eigen::MatrixXd g = M(2, 1, {T * T / 2, T});
    const SteadyState s =
        solve_doubling({M(2, 2, {1, T, 0, 1}), sigma_a * sigma_a * g * g.transpose()},
                       informed(M(2, 2, {1 / (sigma_z * sigma_z), 0, 0, 0})));
    ASSERT_EQ(s.status, RiccatiStatus::converged);
    const double p = s.prior(0, 0);
    EXPECT_NEAR(p / (p + sigma_z * sigma_z), alpha, 1e-12) << "index " << lambda;
  }
}

/// Two devices of one row of docs/theory.md §4: 1-D PV, q = 0.3; standard deviations in
/// mm.
struct Fusion {
  const char* name;
  int ticks_a, ticks_b;  ///< update periods in milliseconds
  double R_a, R_b;       ///< m²
  double artemis, continuous, average, worst, best;
};

void PrintTo(const Fusion& f, std::ostream* os) { *os << f.name; }

class FusionTable : public ::testing::TestWithParam<Fusion> {
 protected:
  const MotionModel model_ = chain_model(2, M(1, 1, {0.3}));

  static Measurement position(double information) {
    return informed(M(2, 2, {information, 0, 0, 0}));
  }
  static double millimetres(const StateMatrix& P) { return 1e3 * std::sqrt(P(0, 0)); }
};

TEST_P(FusionTable, ArtemisSumsTheSymplecticMatrices) {
  const Fusion& f = GetParam();
  const CycleStep steps[] = {
      {discretize(model_, f.ticks_a * 1e-3), position(1 / f.R_a)},
      {discretize(model_, f.ticks_b * 1e-3), position(1 / f.R_b)}};
  EXPECT_NEAR(millimetres(solve_eigenvector(steps).prior), f.artemis, 0.5e-4);
}

TEST_P(FusionTable, ContinuousSumsTheRates) {
  const Fusion& f = GetParam();
  const double rate = 1e3 / (f.ticks_a * f.R_a) + 1e3 / (f.ticks_b * f.R_b);
  const StateMatrix P = solve_continuous(continuous_form(model_), position(rate)).prior;
  EXPECT_NEAR(millimetres(P), f.continuous, 0.5e-4);
  EXPECT_NEAR(1e3 * std::sqrt(0.3 * continuous_chain(2, 0.3 * rate).covariance(0, 0)),
              f.continuous, 0.5e-4);
}

TEST_P(FusionTable, PeriodicCycleIsExact) {
  const Fusion& f = GetParam();
  // Every instant of the hyperperiod at which at least one device reports, both at its
  // end.
  std::vector<CycleStep> cycle;
  std::vector<double> durations;
  const int period = std::lcm(f.ticks_a, f.ticks_b);
  for (int tick = 1, last = 0; tick <= period; ++tick) {
    const double information = (tick % f.ticks_a == 0 ? 1 / f.R_a : 0) +
                               (tick % f.ticks_b == 0 ? 1 / f.R_b : 0);
    if (information == 0) continue;
    durations.push_back((tick - last) * 1e-3);
    cycle.push_back({discretize(model_, durations.back()), position(information)});
    last = tick;
  }
  std::vector<SteadyState> states(cycle.size());
  solve_cycle(cycle, states);
  double worst = 0, best = INFINITY;
  for (const SteadyState& s : states) {
    EXPECT_EQ(s.status, RiccatiStatus::converged);
    worst = std::max(worst, millimetres(s.prior));
    best = std::min(best, millimetres(s.posterior));
  }
  EXPECT_NEAR(worst, f.worst, 0.5e-4);
  EXPECT_NEAR(best, f.best, 0.5e-4);
  // The table averages each posterior with the next prior.
  EXPECT_NEAR(
      millimetres(time_average(model_, durations, states, AverageRule::trapezoid)),
      f.average, 0.5e-4);
  EXPECT_LT(millimetres(time_average(model_, durations, states)), f.average);
}

INSTANTIATE_TEST_SUITE_P(
    Theory, FusionTable,
    ::testing::Values(Fusion{"equal", 20, 20, 1e-3, 1e-3, 19.1714, 13.6426, 13.8003,
                             15.0164, 12.4662},
                      Fusion{"slow_and_precise", 20, 50, 1e-3, 1e-4, 14.9139, 9.6754,
                             10.1205, 12.7200, 7.6292},
                      Fusion{"fast_and_precise", 1, 33, 1e-6, 1e-5, 1.6885, 0.4309,
                             0.4322, 0.4523, 0.4086}));

// Expected: Π propagated on a fine grid and summed by the midpoint rule, whose error is
// (1/n²)/24 of P's curvature: below 1e-8 for n = 2000.
TEST(Published, TimeAverageIsTheIntegral) {
  for (int k = 1; k <= 3; ++k) {
    const MotionModel model = chain_model(k, M(1, 1, {0.7}));
    const double durations[] = {0.3, 0.8};
    StateMatrix S = StateMatrix::Zero(k, k);
    S(0, 0) = 2;
    const CycleStep cycle[] = {{discretize(model, 0.3), informed(S)},
                               {discretize(model, 0.8), informed(3 * S)}};
    SteadyState states[2];
    solve_cycle(cycle, states);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(k, k);
    constexpr int kGrid = 2000;
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < kGrid; ++i) {
        const MotionStep part = discretize(model, durations[j] * (i + 0.5) / kGrid);
        sum += durations[j] / kGrid / 1.1 *
               (part.A * states[1 - j].posterior * part.A.transpose() + part.Q);
      }
    }
    EXPECT_LT(testing::relative(time_average(model, durations, states), sum), 1e-7);
  }
}

// Stacked is one update with the sum of the information; the table's first row calls it
// the worst prior.
TEST(Published, StackedIsTheWorstPriorOfEqualRates) {
  const SteadyState s = solve_doubling(discretize(chain_model(2, M(1, 1, {0.3})), 0.02),
                                       informed(M(2, 2, {2e3, 0, 0, 0})));
  EXPECT_NEAR(1e3 * std::sqrt(s.prior(0, 0)), 15.0164, 0.5e-4);
}

}  // namespace
}  // namespace delos
