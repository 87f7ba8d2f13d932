// Designs of the shipped scenes.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "session/design.h"

namespace delos::session {

inline PluginRegistry& plugins() {
  static PluginRegistry registry({DELOS_PLUGINS});
  return registry;
}

inline Design design_of(const std::string& name) {
  Diagnostics findings;
  auto design = Design::open(std::string(DELOS_SCENES) + "/" + name + ".yaml",
                             plugins(), findings);
  for (const Diagnostic& finding : findings) ADD_FAILURE() << to_string(finding);
  return design.value();
}

/// Change it, which must do.
inline void change(Design& design, std::vector<Override> changes) {
  Diagnostics findings;
  EXPECT_TRUE(design.change(std::move(changes), "", plugins(), findings));
  for (const Diagnostic& finding : findings) ADD_FAILURE() << to_string(finding);
}

}  // namespace delos::session
