// What blind places have instead of a variance.
#pragma once

#include <limits>

namespace delos {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace delos
