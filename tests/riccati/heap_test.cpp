// No solve of the field's hot path touches the heap: malloc is interposed and counted.
#include <gtest/gtest.h>

#include <cstdlib>

#include "delos/riccati/chain.h"
#include "riccati/systems.h"

namespace {

thread_local bool counting = false;
thread_local long allocations = 0;

}  // namespace

#if !defined(__SANITIZE_ADDRESS__)
// glibc's own names for the functions that are replaced here.
extern "C" void* __libc_malloc(std::size_t);
extern "C" void* __libc_calloc(std::size_t, std::size_t);
extern "C" void* __libc_realloc(void*, std::size_t);
extern "C" void* __libc_memalign(std::size_t, std::size_t);

extern "C" void* malloc(std::size_t size) {
  allocations += counting;
  return __libc_malloc(size);
}
extern "C" void* calloc(std::size_t count, std::size_t size) {
  allocations += counting;
  return __libc_calloc(count, size);
}
extern "C" void* realloc(void* old, std::size_t size) {
  allocations += counting;
  return __libc_realloc(old, size);
}
extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) {
  allocations += counting;
  return __libc_memalign(alignment, size);
}
extern "C" int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  allocations += counting;
  *out = __libc_memalign(alignment, size);
  return *out == nullptr;
}
#endif

namespace delos {
namespace {

using testing::Draw;
using testing::informed;

template <class F>
long count_allocations(F f) {
  allocations = 0;
  counting = true;
  f();
  counting = false;
  return allocations;
}

class Heap : public ::testing::Test {
 protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the sanitizer owns malloc";
#endif
  }
  Draw draw_{1};
};

TEST_F(Heap, IsWatched) {
  EXPECT_GT(count_allocations([&] { (void)draw_.matrix(40, 40); }), 0);
}

TEST_F(Heap, IsNotTouchedByTheSpectralPath) {
  for (int d : {3, 6}) {
    const CoordinateMatrix L = testing::cholesky(draw_.spd(d)), S = draw_.spd(d);
    const StateMatrix Y = StateMatrix::Identity(3 * d, 3 * d);
    EXPECT_EQ(count_allocations([&] {
                const SpectralForm f = spectral_form(L, S);
                const CovarianceKind kind = CovarianceKind::prior;
                (void)spectral_covariance(f, 3, {false, 0.1}, kind);
                (void)spectral_pose_covariance(f, 3, {false, 0.1}, kind);
                (void)spectral_gradient(f, 3, {false, 0.1}, kind, Y);
                (void)discrete_chain_time_constant(3, 0.1, 2);
              }),
              0);
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
  EXPECT_EQ(count_allocations([&] { s = solve_doubling(motion, all); }), 0);
  EXPECT_EQ(s.status, RiccatiStatus::converged);
  EXPECT_EQ(count_allocations([&] { lost = solve_doubling(with_bias, few); }), 0);
  EXPECT_EQ(lost.unobservable.cols(), 1);
  EXPECT_EQ(count_allocations([&] { (void)solve_doubling(motion, exact); }), 0);
  EXPECT_EQ(count_allocations([&] { (void)solve_continuous(drift, all.information); }),
            0);
  const StateMatrix Y = StateMatrix::Identity(n, n);
  const CycleStep cycle{motion, all};
  EXPECT_EQ(count_allocations([&] { (void)riccati_gradient(motion, all, s, Y, true); }),
            0);
  EXPECT_EQ(count_allocations([&] { (void)riccati_residual(motion, all, s.prior); }),
            0);
  EXPECT_EQ(count_allocations([&] {
              (void)closed_loop_radius({&cycle, 1}, {&s, 1});
            }),
            0);
}

}  // namespace
}  // namespace delos
