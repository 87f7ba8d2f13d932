#include "delos/text/numbers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>

#include "delos/text/units.h"

namespace delos {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// from_chars refuses a leading plus, which people do write.
std::string_view without_plus(std::string_view text) {
  return text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
}

std::from_chars_result to_double(std::string_view text, double& value) {
  return std::from_chars(text.data(), text.data() + text.size(), value,
                         std::chars_format::general);
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

}  // namespace

NumberText scan_number(std::string_view text) {
  NumberText number;
  const std::string quoted = '\'' + std::string(text) + '\'';
  const std::string_view unsigned_text =
      !text.empty() && (text[0] == '-' || text[0] == '+') ? text.substr(1) : text;
  const std::string word = lower(unsigned_text.substr(0, unsigned_text.find(' ')));
  if (word == "nan" || word == ".nan" || word == "inf" || word == ".inf" ||
      word == "infinity") {
    number.problem = quoted + " isn't a finite number";
    return number;
  }
  if (unsigned_text.empty() || !(is_digit(unsigned_text[0]) || unsigned_text[0] == '.'))
    return number;
  if (unsigned_text.size() > 1 && unsigned_text[0] == '0') {
    const char next = unsigned_text[1];
    if (is_digit(next))
      number.problem =
          quoted + " has a leading zero; numbers are decimal, leave it out";
    else if ((next == 'x' || next == 'o' || next == 'b' || next == 'X') &&
             unsigned_text.size() > 2 &&
             std::isxdigit(static_cast<unsigned char>(unsigned_text[2])))
      number.problem = quoted + " isn't decimal; write the number in decimal notation";
    if (!number.problem.empty()) return number;
  }

  const std::string_view body = without_plus(text);
  const auto [end, failure] = to_double(body, number.value);
  if (failure == std::errc::invalid_argument) return number;
  if (failure == std::errc::result_out_of_range) {
    number.problem = quoted + " is beyond the range of a double";
    return number;
  }
  number.length =
      static_cast<std::size_t>(end - body.data()) + (text.size() - body.size());
  return number;
}

double scaled_decimal(std::string_view number, int exponent) {
  std::string_view body = without_plus(number);
  const std::size_t e = body.find_first_of("eE");
  int own = 0;
  if (e != std::string_view::npos) {
    const std::string_view digits = without_plus(body.substr(e + 1));
    std::from_chars(digits.data(), digits.data() + digits.size(), own);
    body = body.substr(0, e);
  }
  const std::string text = std::string(body) + 'e' + std::to_string(own + exponent);
  double value = 0;
  const auto [end, failure] = to_double(text, value);
  if (failure == std::errc::result_out_of_range) return std::nan("");
  return value;
}

std::string grouped(long long value) {
  const std::string digits = std::to_string(value);
  const std::size_t sign = value < 0 ? 1 : 0;
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > sign && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string shortest(double value) {
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), result.ptr};
}

}  // namespace delos
