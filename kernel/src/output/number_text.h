// Numbers and names as bytes of a file.
#pragma once

#include <string>
#include <string_view>

namespace delos {

/// Append the shortest text that reads back as the same double, whatever the locale.
void append_number(std::string& text, double value);

/// `value` with exactly `decimals` digits after the point; never "-0".
[[nodiscard]] std::string with_decimals(double value, int decimals);

/// A count in groups of three: "1 234 567", with thin spaces.
[[nodiscard]] std::string grouped(std::size_t count);

/// Valid UTF-8 on one line: bytes that aren't become U+FFFD, control characters spaces.
[[nodiscard]] std::string one_line(std::string_view text);

/// One line as the value of an XML attribute.
[[nodiscard]] std::string xml_attribute(std::string_view text);

}  // namespace delos
