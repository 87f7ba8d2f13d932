// Whether a covering problem can be asked.
#pragma once

#include <vector>

#include "delos/optimize/cover.h"

namespace delos {

/// @throws std::invalid_argument all that is wrong with it, but for samples that can't
/// be
///         covered
void check_cover(const CoverProblem& problem);

/// @throws Uncoverable naming these samples, unless there are none
void refuse_uncoverable(std::vector<int> missed);

}  // namespace delos
