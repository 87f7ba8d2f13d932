// Simulations that were stopped go on as if nothing had been.
#include <barrier>
#include <functional>
#include <thread>

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

/// Parts of a simulation as threads that wait for each other.
std::vector<Simulation> in_parts(
    std::size_t of, const System& system, const SimulationOptions& options,
    const std::function<void(SimulationOptions&)>& change = {}) {
  std::barrier meet(static_cast<std::ptrdiff_t>(of));
  std::vector<std::string> said(of);
  std::vector<Simulation> parts(of);
  std::vector<std::thread> threads;
  for (std::size_t index = 0; index < of; ++index) {
    SimulationOptions own = options;
    if (change) change(own);
    own.parts = {index, of, [&, index](const std::string& mine) {
                   said[index] = mine;
                   meet.arrive_and_wait();
                   std::vector<std::string> all = said;
                   meet.arrive_and_wait();
                   return all;
                 }};
    threads.emplace_back(
        [&, index, own] { parts[index] = simulate(system, kResumed, own); });
  }
  for (std::thread& thread : threads) thread.join();
  return parts;
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

/// What one process sums up alone, several do by parts, to the last byte; they go on
/// from what was saved, too.
TEST(Parts, GiveTheSameBytesAsOne) {
  const System system = resumed_system();
  std::string saved;
  SimulationOptions few{.runs = 70, .seed = 9, .seconds = 0.2};
  few.save = [&](const std::string& bytes) { saved = bytes; };
  static_cast<void>(simulate(system, kResumed, few));
  const SimulationOptions whole{.runs = 1300, .seed = 9, .seconds = 0.2, .threads = 1};
  const Simulation alone = simulate(system, kResumed, whole);
  for (const std::size_t of : {1u, 2u, 3u, 7u})
    for (const std::string& before : {std::string(), saved}) {
      SimulationOptions options = whole;
      options.resume = before;
      for (const Simulation& part : in_parts(of, system, options))
        expect_same(part, alone);
    }
}

TEST(Parts, StopTogether) {
  const System system = resumed_system();
  std::atomic<bool> cancel = true;
  SimulationOptions options{.runs = 600, .seed = 9, .seconds = 0.2, .threads = 1};
  std::size_t asked = 0;
  for (const Simulation& part :
       in_parts(2, system, options, [&](SimulationOptions& own) {
         if (asked++ == 0) own.cancel = &cancel;
       })) {
    EXPECT_TRUE(part.cancelled);
    EXPECT_EQ(part.runs, 0u);
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
