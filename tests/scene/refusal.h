// Runs a table of bad scenes against exactly what the user should read about each.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "scene/load.h"

namespace delos::test {

struct Bad {
  const char* name;
  std::string text;
  std::vector<std::string> findings;
};

inline void PrintTo(const Bad& bad, std::ostream* os) { *os << bad.name; }

/// A finding in the scene's text.
inline std::string in_scene(const char* rest) {
  return std::string("scene.yaml:") + rest;
}

inline void expect_refused(const Bad& bad) {
  const Loaded loaded = load(bad.text);
  EXPECT_EQ(loaded.findings, bad.findings) << bad.text;
  EXPECT_FALSE(loaded.scene.has_value());
}

}  // namespace delos::test
