// Quantities as people write them: "50 mm", "60 deg", "100 Hz".
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "delos/api.h"

namespace delos {

/// Convert text to a number in `si_unit`. A bare number is taken to be in SI already.
///
/// Decimal notation only; "010", "0x10", "nan" and "inf" are refused. Besides the SI's
/// own: deg, rad, Hz, in, ft, px, %.
/// @param si_unit the SI unit wanted: "m", "rad", "1/s", "m^2/s^3", "px", "1"
/// @returns the value, or a sentence that says what is wrong and what would be right.
[[nodiscard]] DELOS_API std::variant<double, std::string> parse_quantity(
    std::string_view text, std::string_view si_unit);

/// The shortest decimal text that reads back as the same double.
[[nodiscard]] DELOS_API std::string shortest(double value);

}  // namespace delos
