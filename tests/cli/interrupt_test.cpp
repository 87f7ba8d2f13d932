// Ctrl-C: what was reached is kept, and the program says so.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <thread>

#include "program.h"

namespace delos::test {
namespace {

/// 51·51·143 samples of a slow solver on one thread: ten seconds or more.
constexpr int kSamples = 51 * 51 * 143;

std::vector<std::string> slow(const std::string& command) {
  std::vector<std::string> words = {command, scene("01-acoustic")};
  if (command == "compare") words.push_back(scene("01-acoustic"));
  words.insert(words.end(), {"--set", "sample.volume.step=0.008", "--solver",
                             "eigenvector", "--threads", "1", "--json"});
  return words;
}

/// Wait until it shows progress, which it does after a second of work.
bool at_work(Running& program) {
  const auto last = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < last && !program.ended()) {
    if (program.err().find(" %, ") != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

class Interrupted : public testing::TestWithParam<int> {};

TEST_P(Interrupted, FieldKeepsWhatItReached) {
  const Folder folder;
  std::vector<std::string> words = slow("field");
  words.insert(words.end(), {"--out", "part.csv"});
  Running program(words, folder.path());
  ASSERT_TRUE(at_work(program)) << program.err();
  const auto start = std::chrono::steady_clock::now();
  program.send(GetParam());
  const Finished done = program.wait();
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  ASSERT_EQ(done.code, 3) << done.err;

  int reached = 0, all = 0;
  const std::size_t said = done.err.find("delos: stopped after ");
  ASSERT_NE(said, std::string::npos) << done.err;
  char rest[64] = {};
  ASSERT_EQ(std::sscanf(done.err.c_str() + said,
                        "delos: stopped after %d of %d samples; %63[^\n]", &reached,
                        &all, rest),
            3);
  EXPECT_STREQ(rest, "the rest count as blind");
  EXPECT_EQ(all, kSamples);
  EXPECT_GT(reached, 0);
  EXPECT_LT(reached, kSamples);

  // The four speakers are heard everywhere: what was reached is observable.
  const Json json = done.json();
  EXPECT_EQ(json["samples"], kSamples);
  EXPECT_EQ(json["observable"], reached);
  EXPECT_EQ(json["cancelled"], true);

  std::istringstream table(read_file(folder.path() / "part.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "x,y,z,value,observable");
  int rows = 0, seen = 0;
  bool front = true;
  while (std::getline(table, line)) {
    ++rows;
    if (line.ends_with(",1")) {
      ++seen;
      front = front && seen == rows;
    } else {
      EXPECT_TRUE(line.ends_with(",,0")) << line;
    }
  }
  EXPECT_EQ(rows, kSamples);
  EXPECT_EQ(seen, reached);
  EXPECT_TRUE(front) << "a sample behind the first blind one has a value";
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

INSTANTIATE_TEST_SUITE_P(By, Interrupted, testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& i) {
                           return i.param == SIGINT    ? "CtrlC"
                                  : i.param == SIGTERM ? "Termination"
                                                       : "HangUp";
                         });

/// A terminal that is closed loses no design, with no study either.
TEST(InterruptedOptimize, KeepsTheBestAtAHangUp) {
  const Folder folder;
  Running program({"optimize", scene("09-camera-room"), "--evaluations", "1000000",
                   "--threads", "1", "--out", "best.yaml"},
                  folder.path());
  const auto last = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (program.err().find(" of 1000000 evaluations") == std::string::npos &&
         std::chrono::steady_clock::now() < last && !program.ended())
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  program.send(SIGHUP);
  const Finished done = program.wait();
  EXPECT_EQ(done.code, 3);
  EXPECT_NE(done.err.find("delos: stopped; this is the best so far\n"),
            std::string::npos)
      << done.err;
  EXPECT_NE(done.out.find("stopped: cancelled"), std::string::npos) << done.out;
  EXPECT_EQ(run({"check", "best.yaml"}, folder.path()).code, 0);
}

/// Half a comparison says nothing.
TEST(InterruptedCompare, WritesNothing) {
  const Folder folder;
  std::vector<std::string> words = slow("compare");
  words.insert(words.end(), {"--out", "part.csv"});
  Running program(words, folder.path());
  ASSERT_TRUE(at_work(program)) << program.err();
  program.send(SIGINT);
  const Finished done = program.wait();
  EXPECT_EQ(done.code, 3);
  EXPECT_EQ(done.out, "");
  EXPECT_NE(
      done.err.find(
          "delos: stopped; a comparison needs every scene, nothing was written\n"),
      std::string::npos)
      << done.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace delos::test
