// What can't be simulated says so.
#include "simulation/simulated.h"

namespace delos::test {
namespace {

std::string refused(const System& system, const SimulationOptions& options = {}) {
  try {
    static_cast<void>(simulate(system, kOrigin, options));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Refusal, SaysWhy) {
  System system = moving(2, {axis(0, 1e-3, 50), axis(1, 1e-3, 50)});
  EXPECT_NE(refused(system).find("not every direction is observed"), std::string::npos);
  system.devices.push_back(axis(2, 1e-3, 50));
  EXPECT_EQ(refused(system, {.runs = 2, .seconds = 0.1}), "");
  EXPECT_NE(refused(system, {.runs = 1}).find("two runs"), std::string::npos);
  EXPECT_NE(refused(system, {.runs = 2, .path = GivenPath{{0}, {{0, 0, 0}}}})
                .find("two points"),
            std::string::npos);
  EXPECT_NE(
      refused(system, {.runs = 2,
                       .path = GivenPath{{0, 1, 1}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}})
          .find("that of point 3"),
      std::string::npos);
  System single = system;
  single.covariance = CovarianceKind::single;
  EXPECT_NE(refused(single).find("single"), std::string::npos);
  System artemis = system;
  artemis.fusion = Fusion::artemis;
  EXPECT_NE(refused(artemis).find("artemis"), std::string::npos);
  System later = system;
  later.lag = 0.01;
  EXPECT_NE(refused(later).find("lag"), std::string::npos);
  System approximate = system;
  approximate.exposures = ExposureModel::averaged;
  EXPECT_EQ(refused(approximate, {.runs = 2, .seconds = 0.1}), "");  // nothing exposes
  for (PlacedDevice& placed : approximate.devices) placed.exposure = 0.01;
  EXPECT_NE(refused(approximate).find("approximations"), std::string::npos);
  System odd = system;
  odd.fusion = Fusion::periodic;
  odd.devices[0].period = 1 / 50.0 * std::sqrt(2.0);
  EXPECT_NE(refused(odd).find("rates"), std::string::npos);
}

TEST(Refusal, LetsACancelledSimulationEnd) {
  const System system =
      moving(2, {axis(0, 1e-3, 50), axis(1, 1e-3, 50), axis(2, 1e-3, 50)});
  const std::atomic<bool> cancel = true;
  const Simulation s = simulate(system, kOrigin, {.runs = 100, .cancel = &cancel});
  EXPECT_TRUE(s.cancelled);
  EXPECT_EQ(s.runs, 0u);
}

}  // namespace
}  // namespace delos::test
