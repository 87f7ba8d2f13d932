// Small problems of all kinds against enumeration of all selections.
#include <gtest/gtest.h>

#include <stdexcept>

#include "cover/instances.h"

namespace delos::test {
namespace {

struct Kind {
  const char* name;
  Variety variety;
};

class BruteForce : public testing::TestWithParam<Kind> {};

TEST_P(BruteForce, ProvenIsTheOptimumAndNoBoundExceedsIt) {
  int solved = 0, infeasible = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const CoverProblem problem = random_cover(GetParam().variety, seed);
    CoverOptions options;
    options.seed = seed;
    options.threads = 1;
    options.seconds = 1e9;
    double last_bound = 0;
    std::vector<double> bounds;
    options.progress = [&](const CoverProgress& now) {
      EXPECT_GE(now.bound, last_bound);
      last_bound = now.bound;
      bounds.push_back(now.bound);
    };
    CoverAnswer answer;
    try {
      answer = solve_cover(problem, options);
    } catch (const std::invalid_argument&) {
      // Two of a group are in, or a sample has too few seers: both leave no cover.
      EXPECT_EQ(enumerated(problem), std::numeric_limits<double>::infinity()) << seed;
      ++refused;
      continue;
    }
    const double optimum = enumerated(problem);
    if (answer.stop == CoverStop::infeasible) {
      EXPECT_EQ(optimum, std::numeric_limits<double>::infinity()) << seed;
      EXPECT_TRUE(answer.chosen.empty());
      ++infeasible;
      continue;
    }
    ASSERT_EQ(answer.stop, CoverStop::proven) << seed;
    EXPECT_TRUE(is_cover(problem, answer.chosen)) << seed;
    EXPECT_NEAR(answer.cost, optimum, 1e-9) << seed;
    for (const double bound : bounds) EXPECT_LE(bound, optimum + 1e-9) << seed;
    ++solved;
  }
  // Most of the instances are of use.
  EXPECT_GE(solved, 15) << infeasible << " infeasible, " << refused << " refused";
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, BruteForce,
    testing::Values(
        Kind{"Plain", {}}, Kind{"Dense", {.samples = 20, .density = 0.5}},
        Kind{"Sparse", {.samples = 18, .candidates = 16, .density = 0.2}},
        Kind{"Demands", {.candidates = 14, .density = 0.6, .most_demand = 3}},
        Kind{"Costs", {.candidates = 14, .costs = true}},
        Kind{"RealCosts",
             {.candidates = 14,
              .density = 0.5,
              .most_demand = 2,
              .costs = true,
              .whole = false}},
        Kind{"Groups",
             {.samples = 8, .candidates = 15, .density = 0.4, .groups = true}},
        Kind{"GroupsAndDemands",
             {.samples = 6,
              .candidates = 15,
              .density = 0.6,
              .most_demand = 3,
              .costs = true,
              .groups = true}},
        Kind{"All",
             {.samples = 6,
              .candidates = 16,
              .density = 0.6,
              .most_demand = 2,
              .costs = true,
              .whole = false,
              .groups = true,
              .fixed = true}}),
    [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace delos::test
