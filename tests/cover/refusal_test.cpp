// What can't be covered, and what isn't a problem.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "delos/optimize/cover.h"

namespace delos::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Three samples; candidates that see {0, 1}, {1, 2}, {2}.
CoverProblem small() {
  CoverProblem p;
  p.samples = 3;
  p.start = {0, 2, 4, 5};
  p.seen = {0, 1, 1, 2, 2};
  p.cost = {1, 1, 1};
  p.demand = {1, 1, 1};
  return p;
}

std::string refusal(const CoverProblem& problem) {
  try {
    (void)solve_cover(problem, {});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(CoverRefusal, NothingToSeeOrToChoose) {
  EXPECT_THAT(refusal({}), HasSubstr("there are no samples to see"));
  EXPECT_THAT(refusal({}), HasSubstr("there are no candidates"));
  EXPECT_EQ(refusal(small()), "");
}

TEST(CoverRefusal, ListsThatDontFit) {
  CoverProblem p = small();
  p.cost.pop_back();
  p.demand.push_back(1);
  EXPECT_EQ(refusal(p), "there are 2 costs, wanted 3; there are 4 demands, wanted 3");
  p = small();
  p.start[3] = 4;
  EXPECT_THAT(refusal(p), HasSubstr("don't span the list"));
  p = small();
  p.start[1] = 5;
  EXPECT_THAT(refusal(p), HasSubstr("start of candidate 2 lies before"));
  p = small();
  p.seen = {1, 0, 1, 2, 2};
  EXPECT_THAT(refusal(p),
              HasSubstr("candidate 0 sees samples that don't exist, or not"));
  p = small();
  p.seen[4] = 3;
  EXPECT_THAT(refusal(p), HasSubstr("candidate 2 sees samples that don't exist"));
}

TEST(CoverRefusal, ValuesWithoutSense) {
  CoverProblem p = small();
  p.cost[1] = 0;
  p.demand[2] = -1;
  EXPECT_EQ(
      refusal(p),
      "the cost of candidate 1 isn't positive; the demand of sample 2 is negative");
}

TEST(CoverRefusal, TwoOfAGroupFixedIn) {
  CoverProblem p = small();
  p.group = {0, 7, 7};
  p.fixed = {Membership::free, Membership::in, Membership::in};
  EXPECT_EQ(refusal(p), "candidates 1 and 2 are both fixed in, but of one group");
}

TEST(CoverRefusal, NamesSamplesThatTooFewSee) {
  CoverProblem p = small();
  p.demand = {1, 3, 2};
  EXPECT_THAT(uncoverable(p), ElementsAre(1));
  EXPECT_EQ(refusal(p), "too few candidates see sample 1");
  // Of a group only one counts, and one that is fixed out not at all.
  p.group = {-1, 4, 4};
  p.fixed = {Membership::out, Membership::free, Membership::free};
  p.demand = {1, 1, 2};
  EXPECT_THAT(uncoverable(p), ElementsAre(0, 2));
  EXPECT_EQ(refusal(p), "too few candidates see samples 0, 2");
  p.demand = {0, 1, 1};
  EXPECT_THAT(uncoverable(p), IsEmpty());
  EXPECT_EQ(solve_cover(p, {}).chosen, (std::vector<int>{1}));
}

// Each sample has a seer, but both are of one group: only enumeration can tell.
TEST(CoverRefusal, GroupsThatLeaveNoCover) {
  CoverProblem p;
  p.samples = 2;
  p.start = {0, 1, 2};
  p.seen = {0, 1};
  p.cost = {1, 1};
  p.demand = {1, 1};
  p.group = {0, 0};
  EXPECT_THAT(uncoverable(p), IsEmpty());
  const CoverAnswer answer = solve_cover(p, {});
  EXPECT_EQ(answer.stop, CoverStop::infeasible);
  EXPECT_FALSE(answer.found());
  EXPECT_TRUE(answer.chosen.empty());
}

}  // namespace
}  // namespace delos::test
