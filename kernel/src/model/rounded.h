// Numbers with a few digits, for people.
#pragma once

#include <string>

namespace delos {

/// `value` with `digits` significant digits, trailing zeros left out. Decimal notation
/// between 10⁻⁴ and 10⁶, scientific outside.
[[nodiscard]] std::string rounded(double value, int digits);

}  // namespace delos
