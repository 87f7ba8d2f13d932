// Numbers and texts as bytes, for processes of one program.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace delos {

class ByteWriter {
 public:
  void put(std::uint64_t value) { append(&value, sizeof value); }
  void put(double value) { append(&value, sizeof value); }
  void put(std::string_view text) {
    put(std::uint64_t{text.size()});
    append(text.data(), text.size());
  }
  void put(std::span<const double> numbers) {
    put(std::uint64_t{numbers.size()});
    append(numbers.data(), numbers.size_bytes());
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  void clear() { bytes_.clear(); }

 private:
  void append(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }
  std::string bytes_;
};

/// @throws std::runtime_error there are fewer bytes than are read
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  [[nodiscard]] bool at_end() const { return bytes_.empty(); }
  std::uint64_t whole() { return plain<std::uint64_t>(); }
  double real() { return plain<double>(); }
  std::string text() { return std::string(take(whole())); }
  std::vector<double> numbers() {
    const std::uint64_t count = whole();
    if (count > bytes_.size() / sizeof(double)) (void)take(bytes_.size() + 1);
    const std::string_view raw = take(count * sizeof(double));
    std::vector<double> all(count);
    if (!raw.empty()) std::memcpy(all.data(), raw.data(), raw.size());
    return all;
  }

 private:
  template <class Plain>
  Plain plain() {
    Plain value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view take(std::uint64_t size) {
    if (size > bytes_.size())
      throw std::runtime_error("another process sent less than it meant to");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }
  std::string_view bytes_;
};

}  // namespace delos
