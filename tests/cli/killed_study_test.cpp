// A study whose program is killed again and again.
#include <gtest/gtest.h>
#include <signal.h>

#include <random>

#include "studies.h"

namespace delos::test {
namespace {

// Killed at any moment, resumed, killed again: in the end the same design, the same
// history and the same file as if nothing had happened.
TEST(Study, SurvivesTwentyKills) {
  const Folder folder;
  const std::filesystem::path whole = folder.path() / "whole",
                              killed = folder.path() / "killed";
  const auto more = [&](const std::filesystem::path& file) {
    return std::vector<std::string>{"optimize",      scene("10-better-speakers"),
                                    "--seed",        "7",
                                    "--evaluations", "1200",
                                    "--threads",     "2",
                                    "--json",        "--study",
                                    file.string()};
  };
  const Finished reference = run(more(whole));
  ASSERT_EQ(reference.code, 0) << reference.err;
  const int all = evaluations(whole);

  // Each time a little further, by what the file holds, and then some.
  std::mt19937_64 random(20);
  std::uniform_int_distribution<int> more_microseconds(0, 5000);
  for (int kill = 0; kill < 20; ++kill) {
    const bool begun = std::filesystem::exists(killed);
    Running program(
        begun ? std::vector<std::string>{"study", killed.string(), "resume", "--json"}
              : more(killed));
    ASSERT_TRUE(reached(program, [&] {
      return evaluations(killed) >= kill * all / 40;
    })) << kill;
    std::this_thread::sleep_for(std::chrono::microseconds(more_microseconds(random)));
    program.send(SIGKILL);
    EXPECT_EQ(program.wait().code, 128 + SIGKILL) << kill;
  }
  const Finished last = run({"study", killed.string(), "resume", "--json"});
  ASSERT_EQ(last.code, 0) << last.err;
  EXPECT_EQ(last.json()["variables"], reference.json()["variables"]);
  EXPECT_EQ(last.json()["best"], reference.json()["best"]);
  EXPECT_EQ(exported(killed), exported(whole));
  // It works twice.
  EXPECT_EQ(run({"study", killed.string(), "resume", "--json"}).json()["best"],
            reference.json()["best"]);
  EXPECT_EQ(exported(killed), exported(whole));
}

}  // namespace
}  // namespace delos::test
