// The part of the manual that the program writes.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "sources.h"

namespace delos::test {
namespace {

/// Standard output of a command; the test's own surroundings without other plugins.
std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(("env -u DELOS_PLUGIN_PATH " + command).c_str(), "r");
  if (pipe == nullptr) return text;
  std::array<char, 4096> part{};
  while (const std::size_t n = fread(part.data(), 1, part.size(), pipe)) {
    text.append(part.data(), n);
  }
  EXPECT_EQ(pclose(pipe), 0) << command;
  return text;
}

/// The first line says how the file is made; the rest is made so.
TEST(Manual, ListsTheDevicesAsTheyAre) {
  const std::string file = read(root() / "docs/devices.md");
  const std::string made = output_of("'" DELOS_PROGRAM "' devices --markdown");
  const std::string first = "<!-- Written by: delos devices --markdown -->\n\n";
  ASSERT_FALSE(made.empty());
  EXPECT_EQ(file, first + made) << "docs/devices.md is out of date; write it anew";
}

}  // namespace
}  // namespace delos::test
