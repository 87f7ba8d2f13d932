// Small scenes for searches.
#pragma once

#include <string>

#include "delos/optimize/optimize.h"
#include "shipped_scenes/shipped.h"

namespace delos::test {

/// A target at the origin, the rest of the scene to be added.
inline const std::string kOneTarget = R"(delos: 1
name: One target
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {points: [[0, 0, 0]]}
)";

inline Scene parse(const std::string& text) {
  Diagnostics findings;
  const auto scene = parse_scene(text, "scene.yaml", {}, plugins(), findings);
  for (const Diagnostic& finding : findings) ADD_FAILURE() << to_string(finding);
  return scene.value();
}

inline OptimizeResult search(const Scene& scene, OptimizeOptions options = {}) {
  if (options.threads == 0) options.threads = 2;
  return optimize(scene, plugins(), options);
}

}  // namespace delos::test
