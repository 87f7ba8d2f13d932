// Decimal numbers as text, strictly: what looks odd is refused, not guessed at.
#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "delos/api.h"

namespace delos {

/// A number at the beginning of a text.
struct NumberText {
  double value = 0;
  std::size_t length = 0;  ///< characters of it; 0: the text begins with no number
  std::string problem;     ///< not empty: why the number can't be taken
};

/// Read as much of `text` as is a number in decimal notation.
[[nodiscard]] DELOS_API NumberText scan_number(std::string_view text);

/// value·10^exponent of a number's text, rounded once: "104.85" and −2 give 1.0485.
/// @pre scan_number() takes the whole of `number`.
[[nodiscard]] DELOS_API double scaled_decimal(std::string_view number, int exponent);

/// "1,000,000"
[[nodiscard]] DELOS_API std::string grouped(long long value);
template <std::integral Integer>
[[nodiscard]] std::string grouped(Integer value) {
  return grouped(static_cast<long long>(value));
}

}  // namespace delos
