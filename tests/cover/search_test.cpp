// How a search runs and ends: the same for any number of threads, on time, on demand.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "cover/cover_selection.h"
#include "cover/instances.h"
#include "cover/lagrangian.h"

namespace delos::test {
namespace {

/// Too hard to prove within the tests' time.
CoverProblem hard() {
  return random_cover({.samples = 400, .candidates = 900, .density = 0.02}, 5);
}

TEST(CoverSearch, IsTheSameForAnyNumberOfThreads) {
  const CoverProblem problem = hard();
  CoverOptions options;
  options.rounds = 4;
  options.seconds = 1e9;
  options.threads = 1;
  const CoverAnswer one = solve_cover(problem, options);
  options.threads = 3;
  const CoverAnswer three = solve_cover(problem, options);
  EXPECT_EQ(one.stop, CoverStop::budget);
  EXPECT_EQ(one.chosen, three.chosen);
  EXPECT_EQ(one.lower_bound, three.lower_bound);
  EXPECT_EQ(one.moves, three.moves);
  EXPECT_TRUE(is_cover(problem, one.chosen));
  options.seed = 2;
  EXPECT_NE(solve_cover(problem, options).moves, one.moves);
}

TEST(CoverSearch, EndsWhereItIsAskedTo) {
  const CoverProblem problem = hard();
  std::atomic<bool> cancel = false;
  CoverOptions options;
  options.cancel = &cancel;
  options.seconds = 1e9;
  options.progress = [&](const CoverProgress& now) {
    if (now.cost < 1e300) cancel = true;
  };
  const CoverAnswer cancelled = solve_cover(problem, options);
  EXPECT_EQ(cancelled.stop, CoverStop::cancelled);
  EXPECT_TRUE(is_cover(problem, cancelled.chosen));

  options.cancel = nullptr;
  options.stop_at = cancelled.cost;
  const CoverAnswer target = solve_cover(problem, options);
  EXPECT_EQ(target.stop, CoverStop::target);
  EXPECT_LE(target.cost, cancelled.cost);
  EXPECT_GT(target.cost, target.lower_bound);

  options.stop_at.reset();
  options.seconds = 0.2;
  EXPECT_EQ(solve_cover(problem, options).stop, CoverStop::budget);
}

// 100 candidates that see 3 samples each and none twice, hidden among 3,000 that see 3
// at random. No cover is smaller, since 300 samples want at least 300/3; a short search
// doesn't find it. The bound is 100 and may not be rounded beyond.
TEST(CoverSearch, BoundsAHiddenPartitionExactly) {
  CoverOptions options;
  options.rounds = 1;
  const CoverAnswer answer = solve_cover(hidden_partition(300, 3, 3000, 1), options);
  EXPECT_EQ(answer.lower_bound, 100);
  EXPECT_GT(answer.cost, 101);
}

// With no time at all: the greedy cover, and a bound by prices. A candidate's cost,
// shared out evenly, pays for its samples, of each the least share: Σ_i min 1/|S(j)|.
TEST(CoverSearch, HasACoverAndABoundHoweverShortTheTime) {
  const CoverProblem problem = hard();
  std::vector<double> price(static_cast<std::size_t>(problem.samples), 1);
  for (int j = 0; j < problem.candidates(); ++j)
    for (auto k = problem.start[j]; k < problem.start[j + 1]; ++k) {
      double& own = price[problem.seen[k]];
      own = std::min(
          own, 1.0 / static_cast<double>(problem.start[j + 1] - problem.start[j]));
    }
  double sum = 0;
  for (const double p : price) sum += p;
  CoverOptions options;
  options.seconds = 1e-9;
  const CoverAnswer answer = solve_cover(problem, options);
  EXPECT_EQ(answer.stop, CoverStop::budget);
  EXPECT_TRUE(is_cover(problem, answer.chosen));
  EXPECT_EQ(answer.cost, CoverSelection(core_of(problem)).best_cost());
  EXPECT_EQ(answer.lower_bound, std::ceil(sum));
  EXPECT_GT(sum, 10);
}

// The first steps of a bound: prices that no candidate's cost falls short of, each as
// high as the others let it, by definition.
TEST(CoverSearch, RaisesPricesAsFarAsTheyGo) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const CoverProblem problem = random_cover(
        {.samples = 60, .candidates = 90, .density = 0.1, .costs = true}, seed);
    const CoverCore core = core_of(problem);
    if (!unmet(core).empty()) continue;
    Lagrangian dual(core);
    double before = 0, sum = 0;
    for (int step = 0; step < 8; ++step) {
      dual.step(1e9);
      EXPECT_GE(dual.bound(), before);
      before = dual.bound();
    }
    for (const double u : dual.multipliers()) sum += u;
    EXPECT_NEAR(dual.bound(), sum, 1e-9 * sum);
    for (const double r : dual.reduced_costs()) EXPECT_GE(r, -1e-9);
    for (int i = 0; i < core.samples(); ++i) {
      double room = 1e9;
      for (const int j : core.seers[i])
        room = std::min(room, dual.reduced_costs()[j] / core.cost[j]);
      EXPECT_LT(room, 0.05) << "sample " << i;
    }
  }
}

// Whole, but large: prices in cents. The proof is exact nevertheless.
TEST(CoverSearch, ProvesLargeWholeCosts) {
  CoverProblem problem = random_cover({.candidates = 14, .costs = true}, 2);
  for (double& cost : problem.cost) cost = 1e6 * cost + 1;
  const CoverAnswer answer = solve_cover(problem, {});
  EXPECT_TRUE(answer.proven());
  EXPECT_EQ(answer.cost, enumerated(problem));
}

/// Greedy's worst case, k = 2⁵ − 2 pairs: two candidates see half of each pair; greedy
/// takes those that see both halves of 16, 8, 4, 2, … pairs, which are more.
/// Source: Johnson (1974), J. Comput. Syst. Sci. 9, 256–278; Feige (1998), J. ACM 45,
/// 634.
TEST(CoverSearch, BeatsGreedyByMoreThanThree) {
  constexpr int kLevels = 9;
  constexpr int kPairs = (1 << kLevels) - 1;
  CoverProblem p;
  p.samples = 2 * kPairs;
  p.demand.assign(p.samples, 1);
  const auto close = [&] {
    p.start.push_back(static_cast<std::int64_t>(p.seen.size()));
    p.cost.push_back(1);
  };
  for (int half = 0; half < 2; ++half) {
    for (int i = 0; i < kPairs; ++i) p.seen.push_back(2 * i + half);
    close();
  }
  int at = 0;
  for (int level = kLevels - 1; level >= 0; --level) {
    for (int i = 0; i < 2 << level; ++i) p.seen.push_back(at++);
    close();
  }
  const CoverCore core = core_of(p);
  const CoverSelection greedy(core);
  EXPECT_EQ(greedy.best_cost(), kLevels);  // 9 against 2
  const CoverAnswer answer = solve_cover(p, {});
  EXPECT_EQ(answer.cost, 2);
  EXPECT_TRUE(answer.proven());
}

}  // namespace
}  // namespace delos::test
