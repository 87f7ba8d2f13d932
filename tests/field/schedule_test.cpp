// Cycles of updates, by hand.
#include "delos/rig/schedule.h"

#include <gtest/gtest.h>

#include "support/rigs.h"

namespace delos {
namespace {

System with_rates(Fusion fusion, const std::vector<double>& rates,
                  const std::vector<double>& phases = {}) {
  System system;
  system.fusion = fusion;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    system.devices.push_back(
        testing::place("d", std::make_shared<testing::TestRange>(1), Pose{}, rates[i]));
    if (!phases.empty()) system.devices.back().phase = phases[i];
  }
  return system;
}

std::vector<UpdateSlot> cycle(const System& system) {
  return std::get<std::vector<UpdateSlot>>(update_cycle(system));
}

TEST(Schedule, EqualRatesAreOneInstant) {
  const auto slots = cycle(with_rates(Fusion::periodic, {50, 50, 50}));
  ASSERT_EQ(slots.size(), 1u);
  EXPECT_DOUBLE_EQ(slots[0].interval, 0.02);
  EXPECT_EQ(slots[0].devices, (std::vector<int>{0, 1, 2}));
}

// 50 Hz and 20 Hz repeat after 0.1 s: instants 0, 20, 40, 50, 60, 80 ms.
TEST(Schedule, TwoRatesRepeatAfterTheirCommonPeriod) {
  const auto slots = cycle(with_rates(Fusion::periodic, {50, 20}));
  const double interval[] = {0.02, 0.02, 0.02, 0.01, 0.01, 0.02};
  const std::vector<int> who[] = {{0, 1}, {0}, {0}, {1}, {0}, {0}};
  ASSERT_EQ(slots.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(slots[i].interval, interval[i], 1e-12) << i;
    EXPECT_EQ(slots[i].devices, who[i]) << i;
  }
}

// 1000 Hz and 1/0.033 Hz, which no decimal fraction of a hertz is exactly: 33 instants.
TEST(Schedule, RatesThatAreNoRoundNumbersStillRepeat) {
  EXPECT_EQ(cycle(with_rates(Fusion::periodic, {1000, 1 / 0.033})).size(), 33u);
  EXPECT_EQ(cycle(with_rates(Fusion::periodic, {1000, 30.303030303})).size(), 33u);
}

TEST(Schedule, PhasesShiftInstantsWithinTheCycle) {
  const auto slots = cycle(with_rates(Fusion::periodic, {50, 50}, {0, 0.025}));
  ASSERT_EQ(slots.size(), 2u);
  EXPECT_NEAR(slots[0].interval, 0.015, 1e-12);
  EXPECT_NEAR(slots[1].interval, 0.005, 1e-12);
  EXPECT_EQ(slots[1].devices, (std::vector<int>{1}));
}

TEST(Schedule, SequentialTakesTurnsOfEachPeriod) {
  const auto slots = cycle(with_rates(Fusion::sequential, {1000, 500}));
  ASSERT_EQ(slots.size(), 2u);
  EXPECT_DOUBLE_EQ(slots[0].interval, 0.001);
  EXPECT_DOUBLE_EQ(slots[1].interval, 0.002);
  EXPECT_EQ(slots[1].devices, (std::vector<int>{1}));
}

TEST(Schedule, RatesWithoutAShortCycleAreRefusedInWords) {
  for (const double rate : {49.999, 50 * 1.4142135623730951}) {
    const auto answer = update_cycle(with_rates(Fusion::periodic, {50, rate}));
    ASSERT_TRUE(std::holds_alternative<std::string>(answer)) << rate;
    EXPECT_EQ(
        std::get<std::string>(answer),
        "fusion: the devices' rates repeat only after more than 2000 updates; use "
        "rates in simple ratios, or fusion: continuous");
  }
}

}  // namespace
}  // namespace delos
