// The distance from 1 to the next double: what rounding is measured by.
#pragma once

#include <limits>

namespace delos {

inline constexpr double kEps = std::numeric_limits<double>::epsilon();

}  // namespace delos
