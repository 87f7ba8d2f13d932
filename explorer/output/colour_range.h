// What colours stand for, where several pictures share them.
#pragma once

#include <array>

#include "delos/api.h"

namespace delos {

/// What colours stand for, the same in all pictures that are compared.
struct ColourRange {
  double low = 0, high = 0;       ///< SI; values beyond take the nearer end's colour
  bool log10 = false;             ///< colours follow log10 of the value; low > 0
  bool larger_is_better = false;  ///< bright, or blue, is always good
  bool change = false;  ///< values are changes, low = −high: blue better, red worse
};

/// Where a value stands between low and high, 0 to 1.
[[nodiscard]] double colour_position(const ColourRange& colours, double value);

/// The colour of a value: red, green and blue, sRGB, each in [0, 1].
/// @pre finite
[[nodiscard]] DELOS_API std::array<double, 3> colour_of(const ColourRange& colours,
                                                        double value);

}  // namespace delos
