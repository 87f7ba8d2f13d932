// Quantities for people: a few digits and a handy unit.
#pragma once

#include <string>
#include <string_view>

#include "delos/api.h"

namespace delos {

/// A handy unit for a quantity: si · factor is the number that goes with `name`.
struct DisplayUnit {
  std::string name;   ///< "mm", "deg/s"; empty for a bare number
  double factor = 1;  ///< display units per SI unit
};

/// The unit in which values about as large as `si` read best.
///
/// Metres and their squares, seconds, hertz and their rates take a prefix in steps of
/// 1000; radians become degrees; everything else, such as px, stays as it is.
/// @param unit the SI unit: "m", "rad/s", "1"
[[nodiscard]] DELOS_API DisplayUnit display_unit(double si, std::string_view unit);

/// A quantity as one would say it: "81.7 mm", "0.52 deg", "1.2 ms", "1.23e-05 m^2".
/// @param digits significant digits; trailing zeros are left out
/// @returns "∞" where it is infinite and "undefined" where it isn't a number
[[nodiscard]] DELOS_API std::string format_quantity(double si, std::string_view unit,
                                                    int digits = 3);

}  // namespace delos
