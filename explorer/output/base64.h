// Binary data as text.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <type_traits>

namespace delos {

/// Writes bytes to a stream in base64 (RFC 4648, section 4), as they come.
class Base64Stream {
 public:
  explicit Base64Stream(std::ostream& out) : out_(out) {}

  void add(unsigned char byte);

  /// The value's bytes, the lowest first, whatever the machine's order.
  template <typename T>
  void add_little_endian(T value) {
    static_assert(std::is_unsigned_v<T>);
    for (std::size_t i = 0; i < sizeof(T); ++i)
      add(static_cast<unsigned char>(std::uint64_t{value} >> (8 * i)));
  }

  /// Write what is pending, with its padding. Nothing may be added after.
  void finish();

 private:
  void emit();

  std::ostream& out_;
  std::uint32_t group_ = 0;  ///< up to three bytes, the first one highest
  int bytes_ = 0;            ///< how many of them
};

/// Bytes in base64, in one piece.
[[nodiscard]] std::string base64_of(std::string_view bytes);

}  // namespace delos
