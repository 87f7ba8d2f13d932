// What local searches know about their selection, against its definition, and what they
// find where the best is planted.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "cover/cover_annealing.h"
#include "cover/cover_search.h"
#include "cover/instances.h"
#include "support/camera_placement.h"

namespace delos::test {
namespace {

constexpr double kNone = CoverSelection::kNone;

/// Gains and losses by their definition, from nothing but who is selected.
struct Definition {
  const CoverCore& core;
  std::vector<double> weight;
  std::vector<char> chosen;

  explicit Definition(const CoverCore& c)
      : core(c), weight(c.samples(), 1), chosen(c.candidates(), 0) {}

  void follow(const CoverSelection& selection) {
    for (int j = 0; j < core.candidates(); ++j) chosen[j] = selection.has(j);
  }
  [[nodiscard]] int over(int i) const {
    int count = -core.demand[i];
    for (const int j : core.seers[i]) count += chosen[j];
    return count;
  }
  [[nodiscard]] double gain(int j) const {
    double sum = 0;
    for (const int i : core.seen[j]) sum += over(i) < 0 ? weight[i] : 0;
    return sum / core.cost[j];
  }
  [[nodiscard]] double loss(int k) const {
    double sum = 0;
    for (const int i : core.seen[k]) sum += over(i) <= 0 ? weight[i] : 0;
    return sum / core.cost[k];
  }
  [[nodiscard]] int member(int j) const {
    for (int k = 0; k < core.candidates(); ++k)
      if (chosen[k] && core.group[j] >= 0 && core.group[k] == core.group[j]) return k;
    return -1;
  }
  /// gain(j) − loss(k) for the best k that may go, or j's group's member.
  [[nodiscard]] double exchange(int j, const CoverSelection& s, std::int64_t before) {
    const double own = gain(j);
    const int other = member(j);
    chosen[j] = 1;
    double least = kNone;
    for (int k = 0; k < core.candidates(); ++k)
      if (chosen[k] && k != j && (other >= 0 ? k == other : s.moved(k) < before))
        least = std::min(least, loss(k));
    chosen[j] = 0;
    return own - least;
  }
};

void expect_defined(const CoverSelection& selection, const Definition& definition) {
  int missed = 0;
  double cost = 0;
  const CoverCore& core = definition.core;
  for (int i = 0; i < core.samples(); ++i) missed += definition.over(i) < 0;
  for (int j = 0; j < core.candidates(); ++j) {
    if (definition.chosen[j]) cost += core.cost[j];
    EXPECT_NEAR(selection.gain(j), definition.gain(j), 1e-12) << j;
    if (definition.chosen[j]) {
      EXPECT_NEAR(selection.loss(j), definition.loss(j), 1e-12) << j;
    }
    EXPECT_EQ(selection.member(j), definition.member(j));
  }
  EXPECT_EQ(static_cast<int>(selection.missed().size()), missed);
  EXPECT_NEAR(selection.cost(), cost, 1e-9);
}

/// Select and deselect at random, weigh what is missed, and compare after each.
void compare_with_definition(const Variety& variety, std::uint64_t seed) {
  const CoverProblem problem = random_cover(variety, seed);
  if (!uncoverable(problem).empty()) return;
  const CoverCore core = core_of(problem);
  CoverSelection selection(core);
  Definition definition(core);
  std::mt19937_64 random(seed);
  for (int step = 1; step <= 60; ++step) {
    const int j = static_cast<int>(random() % core.candidates());
    if (selection.has(j))
      selection.take(j, step);
    else
      selection.put(j, step);
    if (step % 7 == 0) {
      for (const int i : selection.missed()) ++definition.weight[i];
      selection.weigh_missed();
    }
    definition.follow(selection);
    expect_defined(selection, definition);
    const std::int64_t before = step - static_cast<int>(random() % 3);
    selection.open_losses(before);
    for (int in = 0; in < core.candidates(); ++in) {
      if (selection.has(in)) continue;
      const auto exchange = selection.exchange_for(in, -kNone);
      const double expected = definition.exchange(in, selection, before);
      EXPECT_EQ(exchange.out < 0, expected == -kNone);
      if (exchange.out < 0) continue;
      EXPECT_NEAR(exchange.value, expected, 1e-12);
      definition.chosen[in] = 1;
      EXPECT_NEAR(selection.gain(in) - definition.loss(exchange.out), expected, 1e-12);
      definition.chosen[in] = 0;
    }
  }
}

TEST(CoverSelection, KnowsGainsLossesAndExchanges) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    compare_with_definition({.samples = 20, .candidates = 15}, seed);
    compare_with_definition({.samples = 20,
                             .candidates = 15,
                             .density = 0.5,
                             .most_demand = 3,
                             .costs = true,
                             .whole = false,
                             .groups = true},
                            seed);
  }
}

/// A cover of 12 among `decoys`: no other 12 cover all 120 samples, but by a chance of
/// far below 1e-9.
CoverProblem planted(int decoys, std::uint64_t seed) {
  return hidden_partition(120, 10, decoys, seed);
}

template <typename Search>
int finds(int decoys) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const CoverProblem problem = planted(decoys, seed);
    const CoverCore core = core_of(problem);
    Search search(core, CoverSelection(core), seed);
    EXPECT_GT(search.selection().best_cost(), 14) << "greedy is worse";
    search.run(20'000'000, kNone, 12);
    EXPECT_TRUE(is_cover(problem, search.selection().best()));
    found += search.selection().best_cost() == 12;
  }
  return found;
}

TEST(CoverSearch, FindsThePlantedCover) { EXPECT_EQ(finds<CoverSearch>(200), 5); }

TEST(CoverAnnealing, FindsThePlantedCover) { EXPECT_EQ(finds<CoverAnnealing>(200), 5); }

// 64 cameras are stored, greedy takes over 80: near enough that neither a walk at
// random nor one that only hands missed samples on comes there.
TEST(CoverAnnealing, ComesNearTheStoredCover) {
  const auto* instance = std::find_if(
      std::begin(kCameraPlacements), std::end(kCameraPlacements),
      [](const CameraPlacement& p) { return std::string(p.name) == "AC_11"; });
  ASSERT_NE(instance, std::end(kCameraPlacements));
  const CoverProblem problem = camera_placement(*instance);
  const CoverCore core = core_of(problem);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CoverAnnealing annealing(core, CoverSelection(core), seed);
    EXPECT_GT(annealing.selection().best_cost(), 80) << "greedy is near";
    annealing.run(600'000'000, kNone, 66);
    EXPECT_LE(annealing.selection().best_cost(), 66) << seed;
    EXPECT_TRUE(is_cover(problem, annealing.selection().best()));
  }
}

TEST(CoverAnnealing, StaysBelowWhatOthersFound) {
  const CoverProblem problem = planted(200, 1);
  const CoverCore core = core_of(problem);
  CoverAnnealing annealing(core, CoverSelection(core), 1);
  annealing.run(1'000'000, 14, 13);
  EXPECT_LE(annealing.selection().selected().size(), 13u);
}

TEST(CoverAnnealing, IsForEqualCosts) {
  CoverProblem problem = planted(20, 1);
  EXPECT_TRUE(CoverAnnealing::suits(core_of(problem)));
  problem.cost[3] = 2;
  EXPECT_FALSE(CoverAnnealing::suits(core_of(problem)));
}

}  // namespace
}  // namespace delos::test
