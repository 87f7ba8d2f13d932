// A device's parameters: declared once in its plugin, read by the loader, the
// optimiser, the help and the manual.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "delos/api.h"

namespace delos {

/// What a scene may write for a parameter.
enum class ParamKind : std::uint32_t {
  number,  ///< a number, with a unit of the declared dimension or in SI
  choice,  ///< one of a few words
  vector,  ///< a list of numbers
  matrix,  ///< a list of rows; of numbers: a column
  text,    ///< words, such as a formula
};

/// How a search should step through a number.
enum class ParamScale : std::uint32_t { linear, log };

/// One row of a plugin's parameter table. Static storage; plain data across the library
/// boundary. Made by number(), choice(), vector(), matrix() or text() below.
struct ParamSpec {
  const char* name;                    ///< snake_case, the key in a scene
  ParamKind kind = ParamKind::number;  ///< what a scene may write
  const char* unit = "1";  ///< SI unit of numbers, e.g. "m", "1/m^2"; px for pixels
  double initial = std::numeric_limits<double>::quiet_NaN();  ///< NaN: must be given
  double lower = -std::numeric_limits<double>::infinity();  ///< least value, inclusive
  double upper = std::numeric_limits<double>::infinity();   ///< greatest, inclusive
  ParamScale scale = ParamScale::linear;
  const char* text = nullptr;     ///< default of any other kind, as in a scene
  const char* choices = nullptr;  ///< words of a choice, "one|two|three"
  std::uint32_t length = 0;       ///< length of a vector; 0: any
  const char* help = "";          ///< one sentence

  /// The row with a default.
  [[nodiscard]] constexpr ParamSpec initially(
      std::convertible_to<double> auto value) const {
    ParamSpec row = *this;
    row.initial = static_cast<double>(value);
    return row;
  }
  /// The same of any other kind, written as in a scene.
  [[nodiscard]] constexpr ParamSpec initially(const char* written) const {
    ParamSpec row = *this;
    row.text = written;
    return row;
  }
  /// The row with bounds, inclusive.
  [[nodiscard]] constexpr ParamSpec between(double least, double greatest) const {
    ParamSpec row = *this;
    row.lower = least;
    row.upper = greatest;
    return row;
  }
  [[nodiscard]] constexpr ParamSpec at_least(double least) const {
    return between(least, upper);
  }
  /// The row as a search should step through it: by factors.
  [[nodiscard]] constexpr ParamSpec by_factors() const {
    ParamSpec row = *this;
    row.scale = ParamScale::log;
    return row;
  }
};

/// A number that must be given; ParamSpec's functions add a default and bounds.
[[nodiscard]] constexpr ParamSpec number(const char* name, const char* unit,
                                         const char* help) {
  return {.name = name, .unit = unit, .help = help};
}
/// One of a few words, "one|two|three".
[[nodiscard]] constexpr ParamSpec choice(const char* name, const char* choices,
                                         const char* help) {
  return {.name = name, .kind = ParamKind::choice, .choices = choices, .help = help};
}
/// A list of so many numbers; 0: any.
[[nodiscard]] constexpr ParamSpec vector(const char* name, const char* unit,
                                         std::uint32_t length, const char* help) {
  return {.name = name,
          .kind = ParamKind::vector,
          .unit = unit,
          .length = length,
          .help = help};
}
/// A list of rows.
[[nodiscard]] constexpr ParamSpec matrix(const char* name, const char* help) {
  return {.name = name, .kind = ParamKind::matrix, .help = help};
}

/// Words, such as a formula. A plugin that finds something wrong in them throws
/// Unbuildable with the character.
[[nodiscard]] constexpr ParamSpec text(const char* name, const char* help) {
  return {.name = name, .kind = ParamKind::text, .help = help};
}

/// A parameter's value in SI units. Vectors are n×1 matrices.
using ParamValue = std::variant<double, std::string, Eigen::MatrixXd>;

/// True where both hold the same kind and the same numbers.
[[nodiscard]] DELOS_API bool same_value(const ParamValue& a, const ParamValue& b);

/// A device's checked parameters, in the order of its table; every row has a value.
class DELOS_API ParamValues {
 public:
  /// Add a value, or replace the one of that name.
  void set(std::string_view name, ParamValue value);

  /// The number called `name`, in SI units.
  /// @throws std::out_of_range where the table has no number of that name.
  [[nodiscard]] double operator[](std::string_view name) const;
  /// The chosen word, or the text. @throws std::out_of_range as above.
  [[nodiscard]] const std::string& choice(std::string_view name) const;
  /// The vector (n×1) or matrix. @throws std::out_of_range as above.
  [[nodiscard]] const Eigen::MatrixXd& matrix(std::string_view name) const;

  /// The value called `name`, to be changed. @throws std::out_of_range as above.
  [[nodiscard]] ParamValue& edit(std::string_view name);

  /// All values with their names.
  [[nodiscard]] const std::vector<std::pair<std::string, ParamValue>>& all() const {
    return values_;
  }
  friend DELOS_API bool operator==(const ParamValues& a, const ParamValues& b);

 private:
  [[nodiscard]] const ParamValue& at(std::string_view name) const;
  std::vector<std::pair<std::string, ParamValue>> values_;
};

}  // namespace delos
