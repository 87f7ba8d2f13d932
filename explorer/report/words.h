// Scenes and searches in sentences.
#pragma once

#include <string>
#include <vector>

#include "delos/scene/scene.h"

namespace delos::report {

/// "a, b and c"; with many, "a, b, c and 9 more".
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

/// "any two of west, east and ceiling1 are at least 500 mm apart"
[[nodiscard]] std::string constraint_words(const ConstraintEntry& entry,
                                           const Scene& scene);

/// "(1.2, 0.5, 2.8) m"
[[nodiscard]] std::string place_words(const Eigen::Vector3d& p);

}  // namespace delos::report
