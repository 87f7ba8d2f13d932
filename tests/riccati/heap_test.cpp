// No solve of the field's hot path touches the heap: malloc is interposed and counted.
#include <gtest/gtest.h>

#include "delos/riccati/chain.h"
#include "riccati/systems.h"
#include "support/heap_count.h"

namespace delos {
namespace {

using testing::Draw;
using testing::informed;

using test::allocations;

class Heap : public ::testing::Test {
 protected:
  Draw draw_{1};
};

TEST_F(Heap, IsWatched) {
  EXPECT_GT(allocations([&] { (void)draw_.matrix(40, 40); }), 0u);
  // In the kernel's library too: this one needs room for any number of rows.
  const CoordinateMatrix L = testing::cholesky(draw_.spd(6));
  const Eigen::MatrixXd rows = draw_.matrix(40, 6);
  EXPECT_GT(allocations([&] { (void)spectral_form_of_rows(L, rows); }), 0u);
}

TEST_F(Heap, IsNotTouchedByTheSpectralPath) {
  for (int d : {3, 6}) {
    const CoordinateMatrix L = testing::cholesky(draw_.spd(d)), S = draw_.spd(d);
    const StateMatrix Y = StateMatrix::Identity(3 * d, 3 * d);
    EXPECT_EQ(allocations([&] {
                const SpectralForm f = spectral_form(L, S);
                const CovarianceKind kind = CovarianceKind::prior;
                (void)spectral_covariance(f, 3, {false, 0.1}, kind);
                (void)spectral_pose_covariance(f, 3, {false, 0.1}, kind);
                (void)spectral_gradient(f, 3, {false, 0.1}, kind, Y);
                (void)discrete_chain_time_constant(3, 0.1, 2);
                (void)spectral_covariance(f, 3, {false, 0.1, 0.05}, kind);
                (void)spectral_gradient(f, 3, {false, 0.1, 0.05}, kind, Y);
                (void)exposed_chain_time_constant(3, 0.1, 0.05, 2);
              }),
              0u);
  }
}

TEST_F(Heap, IsNotTouchedByTheGeneralPathAtThirtyStates) {
  const int n = kMaxState;
  const MotionStep motion{0.2 * draw_.matrix(n, n), draw_.spd(n)};
  const Measurement all = informed(draw_.spd(n));
  // Few rows and a constant state that none of them sees: every branch of the
  // observability analysis runs.
  MotionStep with_bias = motion;
  with_bias.A.row(n - 1).setZero();
  with_bias.A.col(n - 1).setZero();
  with_bias.A(n - 1, n - 1) = 1;
  const Eigen::MatrixXd rows = draw_.matrix(2, n - 1);
  StateMatrix S = StateMatrix::Zero(n, n);
  S.topLeftCorner(n - 1, n - 1) = rows.transpose() * rows;
  const Measurement few = informed(S);
  const Measurement exact{S, StateMatrix::Identity(n, n).topRows(3)};
  const MotionStep drift{motion.A - StateMatrix::Identity(n, n), motion.Q};

  SteadyState s, lost;
  EXPECT_EQ(allocations([&] { s = solve_doubling(motion, all); }), 0u);
  EXPECT_EQ(s.status, RiccatiStatus::converged);
  EXPECT_EQ(allocations([&] { lost = solve_doubling(with_bias, few); }), 0u);
  EXPECT_EQ(lost.unobservable.cols(), 1);
  EXPECT_EQ(allocations([&] { (void)solve_doubling(motion, exact); }), 0u);
  EXPECT_EQ(allocations([&] { (void)solve_continuous(drift, all); }), 0u);
  const StateMatrix Y = StateMatrix::Identity(n, n);
  const CycleStep cycle{motion, all};
  EXPECT_EQ(allocations([&] { (void)riccati_gradient(motion, all, s, Y, true); }), 0u);
  EXPECT_EQ(allocations([&] { (void)riccati_residual(motion, all, s.prior); }), 0u);
  EXPECT_EQ(allocations([&] { (void)closed_loop_radius({&cycle, 1}, {&s, 1}); }), 0u);
}

}  // namespace
}  // namespace delos
