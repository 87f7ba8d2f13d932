// The Riccati solvers side by side, at the state of a PV point: n = 6.
//
// The number to watch is `ratio` of spectral_full: how many spectral solves fit in one
// of SLICOT's SB02OD, timed in the same run.
#include <benchmark/benchmark.h>

#include <chrono>
#include <map>

#include "../tests/riccati/slicot.h"
#include "../tests/riccati/systems.h"

namespace {

using namespace delos;
using testing::Draw;

constexpr int kSystems = 256;
constexpr double kDt = 0.01;

/// Random pose-level systems: d coordinates, chain of order k, cond(S) up to 1e4.
struct Systems {
  int d, k;
  CoordinateMatrix L;
  MotionStep motion;
  std::vector<CoordinateMatrix> S;
  std::vector<Measurement> full;

  Systems(int coordinates, int order) : d(coordinates), k(order) {
    Draw draw(1);
    const Eigen::MatrixXd q = draw.spd(d);
    L = testing::cholesky(q);
    motion = discretize(testing::chain_model(k, q), kDt);
    for (int i = 0; i < kSystems; ++i) {
      S.push_back(draw.spd(d, 2, 6));
      full.push_back(testing::informed(testing::embed(S.back(), d * k)));
    }
  }
};

void spectral_form_only(benchmark::State& state) {
  const Systems s(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  int i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(spectral_form(s.L, s.S[i = (i + 1) % kSystems]));
}

void spectral_pose(benchmark::State& state) {
  const Systems s(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  int i = 0;
  for (auto _ : state) {
    const SpectralForm form = spectral_form(s.L, s.S[i = (i + 1) % kSystems]);
    benchmark::DoNotOptimize(
        spectral_pose_covariance(form, s.k, {false, kDt}, CovarianceKind::prior));
  }
}

void spectral_full(benchmark::State& state) {
  const Systems s(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const int n = s.d * s.k;
  int i = 0;
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  for (auto _ : state) {
    const SpectralForm form = spectral_form(s.L, s.S[i = (i + 1) % kSystems]);
    benchmark::DoNotOptimize(
        spectral_covariance(form, s.k, {false, kDt}, CovarianceKind::prior));
  }
  const double ours = std::chrono::duration<double>(Clock::now() - begin).count() /
                      static_cast<double>(state.iterations());
  testing::Slicot slicot(n);
  const auto start = Clock::now();
  for (int j = 0; j < kSystems; ++j)
    benchmark::DoNotOptimize(
        slicot.sb02od(s.motion.A, s.motion.Q, s.full[j].information).P(0, 0));
  const double theirs =
      std::chrono::duration<double>(Clock::now() - start).count() / kSystems;
  state.counters["ratio"] = theirs / ours;
}

void doubling(benchmark::State& state) {
  const Systems s(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  int i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(solve_doubling(s.motion, s.full[i = (i + 1) % kSystems]));
}

/// Thirty states: a dense stable system.
void doubling_thirty(benchmark::State& state) {
  Draw draw(2);
  const MotionStep motion{0.2 * draw.matrix(30, 30), draw.spd(30)};
  const Measurement measurement = testing::informed(draw.spd(30));
  for (auto _ : state) benchmark::DoNotOptimize(solve_doubling(motion, measurement));
}

void eigenvector(benchmark::State& state) {
  const Systems s(3, 2);
  int i = 0;
  for (auto _ : state) {
    const CycleStep step{s.motion, s.full[i = (i + 1) % kSystems]};
    benchmark::DoNotOptimize(solve_eigenvector({&step, 1}));
  }
}

void slicot_sb02od(benchmark::State& state) {
  const Systems s(3, 2);
  testing::Slicot slicot(6);
  int i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        slicot
            .sb02od(s.motion.A, s.motion.Q, s.full[i = (i + 1) % kSystems].information)
            .P(0, 0));
}

void slicot_sb02md(benchmark::State& state) {
  const Systems s(3, 2);
  testing::Slicot slicot(6);
  int i = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        slicot
            .sb02md(s.motion.A, s.motion.Q, s.full[i = (i + 1) % kSystems].information)
            .P(0, 0));
}

BENCHMARK(spectral_form_only)->Args({3, 2})->Args({6, 2});
BENCHMARK(spectral_pose)->Args({3, 1})->Args({3, 2})->Args({3, 3})->Args({6, 2});
BENCHMARK(spectral_full)->Args({3, 1})->Args({3, 2})->Args({3, 3})->Args({6, 2});
BENCHMARK(doubling)->Args({3, 2})->Args({6, 2});
BENCHMARK(doubling_thirty);
BENCHMARK(eigenvector);
BENCHMARK(slicot_sb02od);
BENCHMARK(slicot_sb02md);

}  // namespace
