// The camera placement competition's rooms: stored solutions are covers, and ours are
// as small. The larger ones are in bench_cover.
#include "support/camera_placement.h"

#include <gtest/gtest.h>

namespace delos::test {
namespace {

class Placement : public testing::TestWithParam<CameraPlacement> {};

TEST_P(Placement, StoredCamerasSeeEverySample) {
  const CoverProblem problem = camera_placement(GetParam());
  std::vector<int> stored = stored_cover(GetParam());
  EXPECT_EQ(stored.size(), static_cast<std::size_t>(GetParam().stored));
  EXPECT_TRUE(is_cover(problem, stored));
  stored.pop_back();
  EXPECT_FALSE(is_cover(problem, stored));
}

INSTANTIATE_TEST_SUITE_P(All, Placement, testing::ValuesIn(kCameraPlacements),
                         [](const auto& instance) { return instance.param.name; });

class Reached : public testing::TestWithParam<CameraPlacement> {};

// Greedy needs 9 and 24.
TEST_P(Reached, StoredCount) {
  const CoverProblem problem = camera_placement(GetParam());
  CoverOptions options;
  options.rounds = 20;
  options.seconds = 1e9;
  options.stop_at = GetParam().stored;
  const CoverAnswer answer = solve_cover(problem, options);
  EXPECT_TRUE(is_cover(problem, answer.chosen));
  EXPECT_EQ(answer.cost, GetParam().stored);
  EXPECT_LE(answer.lower_bound, GetParam().stored);
}

INSTANTIATE_TEST_SUITE_P(Small, Reached,
                         testing::Values(kCameraPlacements[0], kCameraPlacements[5]),
                         [](const auto& instance) { return instance.param.name; });

class Proven : public testing::TestWithParam<CameraPlacement> {};

// No cover is smaller than the stored one.
TEST_P(Proven, StoredCount) {
  const CoverProblem problem = camera_placement(GetParam());
  CoverOptions options;
  options.rounds = 20;
  options.seconds = 1e9;
  const CoverAnswer answer = solve_cover(problem, options);
  EXPECT_TRUE(is_cover(problem, answer.chosen));
  EXPECT_EQ(answer.cost, GetParam().stored);
  EXPECT_EQ(answer.lower_bound, GetParam().stored);
  EXPECT_EQ(answer.stop, CoverStop::proven);
}

INSTANTIATE_TEST_SUITE_P(Small, Proven,
                         testing::Values(kCameraPlacements[1], kCameraPlacements[2]),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace delos::test
