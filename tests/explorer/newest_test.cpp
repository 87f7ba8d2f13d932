// The newest request wins, and the end waits for nobody.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "client.h"

namespace delos::test {
namespace {

using Clock = std::chrono::steady_clock;

/// A HiBall's volume at 2 cm: 1.3 million samples of many sightings each, a minute or
/// more.
std::string large_scene(const Folder& folder) {
  return folder
      .write("large.yaml", "delos: 1\nextends: " + scene("hiball/volume") +
                               "\nset: {sample.volume.step: 0.02}\n")
      .string();
}

struct Slow {
  Folder folder;
  Explorer explorer{{large_scene(folder)}};
  std::string session = explorer.open("large.yaml")["session"];
  Answer first;
  std::thread asking;

  Slow() : asking([this] { first = explorer.ask("field", session, {{"most", 0}}); }) {
    std::this_thread::sleep_for(std::chrono::milliseconds(400));
  }
};

TEST(Newest, TakesThePlaceOfTheOneBefore) {
  Slow slow;
  const auto start = Clock::now();
  const Answer coarse = slow.explorer.ask("field", slow.session, {{"most", 1000}});
  EXPECT_EQ(coarse.status, 200);
  slow.asking.join();
  EXPECT_LT(Clock::now() - start, std::chrono::seconds(20));
  EXPECT_EQ(slow.first.status, 409) << slow.first.body.substr(0, 200);
}

TEST(Newest, IsAChange) {
  Slow slow;
  const auto start = Clock::now();
  const Answer changed = slow.explorer.ask(
      "change", slow.session, {{"set", {{{"path", "metric"}, {"value", "eigmax"}}}}});
  EXPECT_EQ(changed.status, 200) << changed.body;
  slow.asking.join();
  EXPECT_LT(Clock::now() - start, std::chrono::seconds(20));
  EXPECT_EQ(slow.first.status, 409);
}

TEST(Newest, LeavesOthersAlone) {
  Slow slow;
  const auto start = Clock::now();
  const std::string other = slow.explorer.open("02-eight-cameras")["session"];
  EXPECT_EQ(slow.explorer.ask("field", other).status, 200);
  EXPECT_LT(Clock::now() - start, std::chrono::seconds(10));
  EXPECT_EQ(slow.first.status, 0) << "it is still at work";
  slow.explorer.ask("undo", slow.session);  // which stops it
  slow.asking.join();
}

TEST(End, ComesAtOnceWhateverIsAtWork) {
  Slow slow;
  const auto start = Clock::now();
  const Finished done = slow.explorer.end();
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.err, "");
  EXPECT_LT(Clock::now() - start, std::chrono::seconds(20));
  slow.asking.join();
  EXPECT_EQ(slow.first.status, 0);
}

}  // namespace
}  // namespace delos::test
