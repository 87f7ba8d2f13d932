// Runs a table of bad scenes against exactly what the user should read about each.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "scene/load.h"
#include "scene/schema.h"

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

/// Whether a finding is about what a value by itself looks like, which a schema can
/// say, too: units and what several values tell together aren't.
inline bool is_of_shape(const std::string& finding) {
  if (finding.find("must be above 0 and at most") != std::string::npos) return false;
  for (const char* phrase :
       {": unknown key", ": expected a mapping", ": expected a list",
        ": expected three numbers", ": expected four numbers", ": expected a whole",
        ": expected a single value", "is none of", ": must be above",
        ": must not be below", ": must be from", ": missing: the format",
        ": missing: how the target", ": missing: where the system",
        ": missing: what measures", ": missing: a word"})
    if (finding.find(phrase) != std::string::npos) return true;
  return false;
}

/// Refused as it should be; by the schema, too, where that can know.
inline void expect_refused(const Bad& bad) {
  const Loaded loaded = load(bad.text);
  EXPECT_EQ(loaded.findings, bad.findings) << bad.text;
  EXPECT_FALSE(loaded.scene.has_value());
  for (const std::string& finding : bad.findings)
    if (is_of_shape(finding)) {
      EXPECT_NE(schema_problem(json_of_yaml(bad.text)), "") << finding << bad.text;
    }
}

}  // namespace delos::test
