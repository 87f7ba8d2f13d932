// Answers with large arrays, as bytes that a page takes without reading numbers from
// text.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "session/json.h"

namespace delos::session {

/// Arrays behind a text, and where each begins.
class Arrays {
 public:
  /// @returns where they begin, bytes from the text's end
  template <class T, class Range>
  std::size_t add(const Range& values) {
    const std::size_t at = bytes_.size();
    for (const auto& value : values) {
      const auto stored = static_cast<T>(value);
      bytes_.append(reinterpret_cast<const char*>(&stored), sizeof stored);
    }
    bytes_.append((4 - bytes_.size() % 4) % 4, '\0');
    return at;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  static_assert(std::endian::native == std::endian::little);
  std::string bytes_;
};

/// Four letters that say what it is, the length of a JSON text as 32 bits, the text,
/// filled up to four bytes, and its arrays; little-endian.
[[nodiscard]] inline std::string packed_text(const char* magic, const Json& head,
                                             const Arrays& arrays) {
  std::string text = text_of(head);
  text.append((4 - text.size() % 4) % 4, ' ');
  const auto length = static_cast<std::uint32_t>(text.size());
  return magic + std::string(reinterpret_cast<const char*>(&length), sizeof length) +
         text + arrays.bytes();
}

}  // namespace delos::session
