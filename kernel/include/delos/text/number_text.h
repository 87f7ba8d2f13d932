// Numbers and names as bytes of a file.
#pragma once

#include <charconv>
#include <string>
#include <string_view>

#include "delos/api.h"

namespace delos {

/// Append the shortest text that reads back as the same double, whatever the locale.
DELOS_API void append_number(std::string& text, double value);

/// std::to_chars() as a string: `precision` digits after the point.
[[nodiscard]] DELOS_API std::string decimal_text(double value, std::chars_format format,
                                                 int precision);

/// `value` with `digits` significant digits, trailing zeros left out. Decimal notation
/// between 10⁻⁴ and 10⁶, scientific outside.
[[nodiscard]] DELOS_API std::string rounded(double value, int digits);

/// `value` with exactly `decimals` digits after the point; never "-0".
[[nodiscard]] DELOS_API std::string with_decimals(double value, int decimals);

/// Valid UTF-8 on one line: bytes that aren't become U+FFFD, control characters spaces.
[[nodiscard]] DELOS_API std::string one_line(std::string_view text);

/// Whether one_line() would make spaces of some of it, which a terminal might obey.
[[nodiscard]] DELOS_API bool has_control(std::string_view text);

/// One line as the value of an XML attribute.
[[nodiscard]] DELOS_API std::string xml_attribute(std::string_view text);

}  // namespace delos
