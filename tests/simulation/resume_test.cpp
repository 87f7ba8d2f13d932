// Simulations that were stopped go on as if nothing had been.
#include "simulation/simulated.h"

namespace delos::test {
namespace {

System resumed_system() { return acoustic_system(); }
const TargetPose kResumed{Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.4}};

void expect_same(const Simulation& one, const Simulation& other) {
  EXPECT_EQ(one.runs, other.runs);
  for (std::size_t c = 0; c < one.covariances.size(); ++c) {
    EXPECT_EQ(one.covariances[c].measured, other.covariances[c].measured);
    EXPECT_EQ(one.covariances[c].error, other.covariances[c].error);
    EXPECT_EQ(one.covariances[c].bound, other.covariances[c].bound);
  }
  for (std::size_t i = 0; i < one.instants.size(); ++i) {
    EXPECT_EQ(one.instants[i].nees.mean, other.instants[i].nees.mean);
    EXPECT_EQ(one.instants[i].nis.mean, other.instants[i].nis.mean);
    EXPECT_EQ(one.instants[i].square, other.instants[i].square);
  }
}

TEST(Resume, GivesTheSameBytesAsRunningThrough) {
  const System system = resumed_system();
  const SimulationOptions whole{.runs = 150, .seed = 9, .seconds = 0.2};
  const Simulation through = simulate(system, kResumed, whole);
  for (const std::size_t until : {1u, 40u, 100u}) {
    std::string saved;
    std::atomic<bool> cancel = false;
    SimulationOptions first = whole;
    first.cancel = &cancel;
    first.progress = [&](std::size_t done, std::size_t) { cancel = done >= until; };
    first.save = [&](const std::string& bytes) { saved = bytes; };
    first.threads = 1;
    const Simulation stopped = simulate(system, kResumed, first);
    ASSERT_TRUE(stopped.cancelled);
    ASSERT_FALSE(saved.empty());
    SimulationOptions rest = whole;
    rest.resume = saved;
    std::size_t first_done = 0;
    rest.progress = [&](std::size_t done, std::size_t) {
      if (first_done == 0) first_done = done;
    };
    expect_same(simulate(system, kResumed, rest), through);
    EXPECT_GT(first_done, 16u);  // what was done isn't done again
  }
}

/// More runs go on from fewer, though the last of those were no whole chunk.
TEST(Resume, GoesOnToMoreRuns) {
  const System system = resumed_system();
  SimulationOptions few{.runs = 70, .seed = 9, .seconds = 0.2};
  std::string saved;
  few.save = [&](const std::string& bytes) { saved = bytes; };
  static_cast<void>(simulate(system, kResumed, few));
  const SimulationOptions through{.runs = 150, .seed = 9, .seconds = 0.2};
  SimulationOptions more = through;
  more.resume = saved;
  expect_same(simulate(system, kResumed, more), simulate(system, kResumed, through));
}

TEST(Resume, RefusesWhatIsOfOtherRuns) {
  const System system = resumed_system();
  SimulationOptions options{.runs = 64, .seed = 9, .seconds = 0.2};
  std::string saved;
  options.save = [&](const std::string& bytes) { saved = bytes; };
  static_cast<void>(simulate(system, kResumed, options));
  options.save = {};
  const auto refuses = [&](SimulationOptions other, std::string bytes) {
    other.resume = std::move(bytes);
    EXPECT_THROW(static_cast<void>(simulate(system, kResumed, other)),
                 std::invalid_argument);
  };
  refuses(options, saved + "x");
  refuses(options, saved.substr(0, saved.size() - 8));
  SimulationOptions shorter = options;
  shorter.seconds = 0.1;
  refuses(shorter, saved);
  SimulationOptions fewer = options;
  fewer.runs = 32;
  refuses(fewer, saved);
}

}  // namespace
}  // namespace delos::test
