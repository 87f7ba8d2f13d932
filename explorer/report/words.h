// Scenes and searches in sentences.
#pragma once

#include <string>
#include <vector>

#include "delos/scene/scene.h"

namespace delos::report {

/// "any two of west, east and ceiling1 are at least 500 mm apart"
[[nodiscard]] std::string constraint_words(const ConstraintEntry& entry,
                                           const Scene& scene);

}  // namespace delos::report
