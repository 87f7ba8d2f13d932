#include "model/rounded.h"

#include <algorithm>
#include <charconv>

namespace delos {
namespace {

std::string to_text(double value, std::chars_format format, int precision) {
  // Room for the widest decimal notation: 309 digits, a point and the decimals.
  char buffer[400];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, format, precision);
  return {buffer, end.ptr};
}

}  // namespace

std::string rounded(double value, int digits) {
  digits = std::clamp(digits, 1, 17);
  if (value == 0) return "0";
  std::string text = to_text(value, std::chars_format::scientific, digits - 1);
  const std::size_t e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));
  std::string tail;
  if (exponent < -4 || exponent >= 6) {
    tail = text.substr(e);
    text.resize(e);
  } else {
    // Rounding first and printing then keeps 1234 with three digits at 1230.
    double kept = value;
    std::from_chars(text.data(), text.data() + text.size(), kept);
    text = to_text(kept, std::chars_format::fixed, std::max(0, digits - 1 - exponent));
  }
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text + tail;
}

}  // namespace delos
