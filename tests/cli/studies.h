// What tests of studies wait for and compare.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "program.h"

namespace delos::test {

/// Wait for something that a running program does, as long as it runs.
template <class Condition>
bool reached(Running& program, Condition&& condition) {
  const auto last = std::chrono::steady_clock::now() + std::chrono::minutes(5);
  while (!condition()) {
    if (program.ended() || std::chrono::steady_clock::now() > last) return condition();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// The whole study, as text.
inline std::string exported(const std::filesystem::path& file) {
  const Finished done = run({"study", file.string(), "export"});
  EXPECT_EQ(done.code, 0) << done.err;
  return done.out;
}

inline Json shown(const std::filesystem::path& file) {
  return run({"study", file.string(), "show", "--json"}).json();
}

/// Evaluations that a study keeps of a round, counted from 1; 0 where there is none.
inline int evaluations(const std::filesystem::path& file, std::size_t round = 1) {
  if (!std::filesystem::exists(file)) return 0;
  const Json rounds = shown(file)["rounds"];
  return rounds.size() < round ? 0 : rounds[round - 1]["evaluations"].get<int>();
}

}  // namespace delos::test
