#include "output/base64.h"

#include <ostream>
#include <sstream>

namespace delos {

void Base64Stream::add(unsigned char byte) {
  group_ = group_ << 8 | byte;
  if (++bytes_ == 3) emit();
}

void Base64Stream::finish() {
  if (bytes_ > 0) emit();
}

void Base64Stream::emit() {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  group_ <<= 8 * (3 - bytes_);
  char text[4];
  for (int i = 0; i < 4; ++i)
    text[i] = i <= bytes_ ? kDigits[group_ >> (18 - 6 * i) & 63] : '=';
  out_.write(text, 4);
  group_ = 0;
  bytes_ = 0;
}

std::string base64_of(std::string_view bytes) {
  std::ostringstream text;
  Base64Stream stream(text);
  for (const char byte : bytes) stream.add(static_cast<unsigned char>(byte));
  stream.finish();
  return text.str();
}

}  // namespace delos
