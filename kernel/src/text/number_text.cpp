#include "delos/text/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace delos {

std::string decimal_text(double value, std::chars_format format, int precision) {
  // Room for the widest decimal notation: 309 digits, a point and the decimals.
  char buffer[400];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, format, precision);
  return {buffer, end.ptr};
}

namespace {

/// Length of the UTF-8 sequence that starts at text[at]; 0 where there is none. Refuses
/// overlong forms, surrogates and what lies beyond U+10FFFF (RFC 3629, section 4).
std::size_t utf8_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
  };
  const auto tail = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return tail(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    if (lead == 0xE0 && byte(1) < 0xA0) return 0;
    if (lead == 0xED && byte(1) > 0x9F) return 0;
    return tail(1) && tail(2) ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    if (lead == 0xF0 && byte(1) < 0x90) return 0;
    if (lead == 0xF4 && byte(1) > 0x8F) return 0;
    return tail(1) && tail(2) && tail(3) ? 4 : 0;
  }
  return 0;
}

/// U+0000 to U+001F, U+007F to U+009F.
bool control(std::string_view text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  return lead < 0x20 || lead == 0x7F ||
         (lead == 0xC2 && at + 1 < text.size() &&
          static_cast<unsigned char>(text[at + 1]) < 0xA0);
}

}  // namespace

bool has_control(std::string_view text) {
  for (std::size_t at = 0; at < text.size(); ++at)
    if (control(text, at)) return true;
  return false;
}

void append_number(std::string& text, double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, end.ptr);
}

std::string with_decimals(double value, int decimals) {
  std::string text =
      decimal_text(value, std::chars_format::fixed, std::clamp(decimals, 0, 60));
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos)
    text.erase(0, 1);
  return text;
}

std::string one_line(std::string_view text) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text, at);
    if (length == 0) {
      line += "\uFFFD";
      ++at;
      continue;
    }
    if (control(text, at))
      line += ' ';
    else
      line += text.substr(at, length);
    at += length;
  }
  return line;
}

std::string xml_attribute(std::string_view text) {
  std::string escaped;
  for (const char c : one_line(text)) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else
      escaped += c;
  }
  return escaped;
}

std::string rounded(double value, int digits) {
  digits = std::clamp(digits, 1, 17);
  if (value == 0) return "0";
  std::string text = decimal_text(value, std::chars_format::scientific, digits - 1);
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
    text = decimal_text(kept, std::chars_format::fixed,
                        std::max(0, digits - 1 - exponent));
  }
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text + tail;
}

}  // namespace delos
