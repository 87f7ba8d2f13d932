// Reductions by themselves: the optimum stays what enumeration says, and what is
// plainly of no use goes.
#include <gtest/gtest.h>

#include "cover/cover_core.h"
#include "cover/instances.h"

namespace delos::test {
namespace {

/// The core as a problem.
CoverProblem problem_of(const CoverCore& core) {
  CoverProblem p;
  p.samples = core.samples();
  p.start = core.seen.start;
  p.seen = core.seen.items;
  p.cost = core.cost;
  p.demand = core.demand;
  p.group = core.group;
  return p;
}

/// Small enough to be enumerated; demands, costs and groups in all combinations.
CoverProblem small_cover(std::uint64_t seed) {
  Variety variety{.samples = 7, .candidates = 12, .density = 0.55};
  variety.most_demand = 1 + static_cast<int>(seed % 3);
  variety.costs = seed % 2 == 0;
  variety.groups = seed % 5 < 2;
  return random_cover(variety, seed);
}

TEST(Reduction, KeepsTheOptimum) {
  int smaller = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const CoverProblem problem = small_cover(seed);
    const double optimum = enumerated(problem);
    if (optimum > 1e300) continue;
    const CoverCore core = reduced(core_of(problem));
    if (core.candidates() < problem.candidates()) ++smaller;
    const double rest = core.samples() == 0 ? 0 : enumerated(problem_of(core));
    EXPECT_NEAR(core.chosen_cost + rest, optimum, 1e-9) << seed;
  }
  EXPECT_GE(smaller, 100);
}

// Wherever reductions are stopped.
TEST(Reduction, KeepsTheOptimumUnfinished) {
  int unfinished = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const CoverProblem problem = small_cover(seed);
    const double optimum = enumerated(problem);
    if (optimum > 1e300) continue;
    const int end = reduced(core_of(problem)).candidates();
    for (int asked = 0; asked < 20; asked += 3) {
      int left = asked;
      const CoverCore core = reduced(core_of(problem), [&] { return left-- <= 0; });
      unfinished += core.candidates() > end;
      const double rest = core.samples() == 0 ? 0 : enumerated(problem_of(core));
      EXPECT_NEAR(core.chosen_cost + rest, optimum, 1e-9) << seed << ", " << asked;
    }
  }
  EXPECT_GE(unfinished, 100);
}

// Candidate 0 sees {0, 1}, 1 sees {0}, 2 the same as 0 but dearer, 3 {2}: 3 is chosen,
// and 0 alone is left, so that it is chosen too.
TEST(Reduction, DecidesWhatIsPlain) {
  CoverProblem p;
  p.samples = 3;
  p.start = {0, 2, 3, 5, 6};
  p.seen = {0, 1, 0, 0, 1, 2};
  p.cost = {1, 1, 2, 1};
  p.demand = {1, 1, 1};
  const CoverCore core = reduced(core_of(p));
  EXPECT_EQ(core.samples(), 0);
  EXPECT_EQ(core.candidates(), 0);
  EXPECT_EQ(core.chosen_cost, 2);
  // Two must see sample 0: now 1 has its use.
  p.demand[0] = 2;
  const CoverAnswer answer = solve_cover(p, {});
  EXPECT_EQ(answer.chosen, (std::vector<int>{0, 1, 3}));
}

}  // namespace
}  // namespace delos::test
