// Directions that aren't observed at a point, for people.
#pragma once

#include <string>
#include <vector>

#include "delos/field/point.h"

namespace delos::session {

/// "lost: z", a line each, and where the place of devices is the reason, why.
[[nodiscard]] std::vector<std::string> lost_directions(const System& system,
                                                       const PointReport& report);

}  // namespace delos::session
