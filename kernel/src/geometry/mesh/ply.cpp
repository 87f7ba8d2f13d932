#include "geometry/mesh/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>

namespace delos {
namespace {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyFormat { text, little, big };

struct PlyProperty {
  std::string name;
  PlyType type{};
  std::optional<PlyType> length;  ///< of a list: the type of what says how long it is
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

std::optional<PlyType> ply_type(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 2>, 8> kNames = {
      {{"char", "int8"},
       {"uchar", "uint8"},
       {"short", "int16"},
       {"ushort", "uint16"},
       {"int", "int32"},
       {"uint", "uint32"},
       {"float", "float32"},
       {"double", "float64"}}};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (name == kNames[i][0] || name == kNames[i][1]) return static_cast<PlyType>(i);
  return std::nullopt;
}

/// The numbers behind a header, one after the other.
class PlyNumbers {
 public:
  PlyNumbers(std::istream& in, PlyFormat format) : in_(in), format_(format) {}

  /// @returns nullopt at the end, and where no finite number stands
  std::optional<double> next(PlyType type) {
    if (format_ == PlyFormat::text) return next_word();
    switch (type) {
      case PlyType::int8:
        return next_binary<std::int8_t>();
      case PlyType::uint8:
        return next_binary<std::uint8_t>();
      case PlyType::int16:
        return next_binary<std::int16_t>();
      case PlyType::uint16:
        return next_binary<std::uint16_t>();
      case PlyType::int32:
        return next_binary<std::int32_t>();
      case PlyType::uint32:
        return next_binary<std::uint32_t>();
      case PlyType::float32:
        return next_binary<float>();
      case PlyType::float64:
        return next_binary<double>();
    }
    return std::nullopt;
  }

 private:
  std::optional<double> next_word() {
    if (!(in_ >> word_)) return std::nullopt;
    double value = 0;
    const char* begin = word_.data() + (word_[0] == '+' ? 1 : 0);
    const char* end = word_.data() + word_.size();
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
      return std::nullopt;
    return value;
  }

  template <class T>
  std::optional<double> next_binary() {
    std::array<char, sizeof(T)> bytes;
    if (!in_.read(bytes.data(), sizeof(T))) return std::nullopt;
    const bool little = std::endian::native == std::endian::little;
    if (little != (format_ == PlyFormat::little))
      std::reverse(bytes.begin(), bytes.end());
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return static_cast<double>(value);
  }

  std::istream& in_;
  PlyFormat format_;
  std::string word_;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
};

bool add_property(std::istream& words, std::vector<PlyElement>& elements) {
  std::string type, length;
  PlyProperty property;
  if (elements.empty() || !(words >> type)) return false;
  if (type == "list") {
    if (!(words >> length >> type)) return false;
    property.length = ply_type(length);
    if (!property.length) return false;
  }
  const auto known = ply_type(type);
  if (!known || !(words >> property.name)) return false;
  property.type = *known;
  elements.back().properties.push_back(std::move(property));
  return true;
}

std::optional<PlyHeader> read_header(std::istream& in) {
  PlyHeader header;
  bool formatted = false;
  std::string line, key, word;
  for (int number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line);
    key.clear();
    words >> key;
    if (number == 1) {
      if (key != "ply") return std::nullopt;
    } else if (key == "format") {
      words >> word;
      formatted = word == "ascii" || word.starts_with("binary_");
      header.format = word == "ascii"               ? PlyFormat::text
                      : word == "binary_big_endian" ? PlyFormat::big
                                                    : PlyFormat::little;
    } else if (key == "element") {
      PlyElement element;
      if (!(words >> element.name >> element.count)) return std::nullopt;
      header.elements.push_back(std::move(element));
    } else if (key == "property") {
      if (!add_property(words, header.elements)) return std::nullopt;
    } else if (key == "end_header") {
      if (!formatted) return std::nullopt;
      return header;
    } else if (key != "comment" && key != "obj_info" && !key.empty()) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

/// What of an element is kept: a place for each property's number, or for its list.
using Kept = std::vector<double*>;

/// Read one member of an element.
/// @param number where the numbers of properties go, by property; null: nowhere
/// @param list, of where the members of the property `of` go
bool read_member(PlyNumbers& numbers, const PlyElement& element, std::size_t limit,
                 const Kept& number, std::size_t of, Claimed<std::size_t>& list) {
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    const auto first = numbers.next(property.length.value_or(property.type));
    if (!first) return false;
    if (!property.length) {
      if (number[p]) *number[p] = *first;
      continue;
    }
    if (!(*first >= 0)) return false;
    if (*first > static_cast<double>(limit)) throw std::length_error("announced");
    for (auto left = static_cast<std::size_t>(*first); left > 0; --left) {
      const auto member = numbers.next(property.type);
      if (!member) return false;
      // An index below 0 names no vertex, nor does one beyond all.
      if (p == of)
        list.push_back(*member >= 0 && *member < 1e15
                           ? static_cast<std::size_t>(*member)
                           : std::numeric_limits<std::size_t>::max());
    }
  }
  return true;
}

}  // namespace

bool read_ply(std::istream& in, SoupPoints& points, SoupPolygons& polygons) {
  const auto header = read_header(in);
  if (!header) return false;
  PlyNumbers numbers(in, header->format);
  const std::size_t limit = points.limit;
  for (const PlyElement& element : header->elements) {
    if (element.count > limit) throw std::length_error("announced");
    const bool vertices = element.name == "vertex", faces = element.name == "face";
    double x = 0, y = 0, z = 0;
    Kept number(element.properties.size());
    std::size_t list = element.properties.size();
    int coordinates = 0;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const std::string& name = property.name;
      if (vertices && !property.length && (name == "x" || name == "y" || name == "z")) {
        number[p] = name == "x" ? &x : name == "y" ? &y : &z;
        ++coordinates;
      }
      if (faces && property.length &&
          (name == "vertex_indices" || name == "vertex_index"))
        list = p;
    }
    if (vertices && coordinates != 3)
      throw MeshProblem{"its vertices don't have x, y and z"};
    Claimed<std::size_t> corners;
    for (std::size_t i = 0; i < element.count; ++i) {
      corners.clear();
      if (!read_member(numbers, element, limit, number, list, corners)) return false;
      if (vertices) points.emplace_back(x, y, z);
      if (faces) polygons.push_back(corners);
    }
  }
  return true;
}

}  // namespace delos
