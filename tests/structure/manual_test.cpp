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
void expect_made_by(const std::string& command, const std::string& file) {
  const std::string made = output_of("'" DELOS_PROGRAM "' " + command);
  ASSERT_FALSE(made.empty());
  EXPECT_EQ(read(root() / file),
            "<!-- Written by: delos " + command + " -->\n\n" + made)
      << file << " is out of date; write it anew";
}

TEST(Manual, ListsTheDevicesAsTheyAre) {
  expect_made_by("devices --markdown", "docs/devices.md");
}

TEST(Manual, ListsTheKeysOfScenesAsTheyAre) {
  expect_made_by("schema --markdown", "docs/scene-keys.md");
}

}  // namespace
}  // namespace delos::test
