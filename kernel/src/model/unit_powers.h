// Units of formulas: how those of the results follow from those of what they read.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace delos {

/// A unit as powers of m, rad and s, to be worked with in place of a number. A number
/// of the formula itself has any unit that it must have in a sum, and none in a
/// product.
struct UnitPowers {
  UnitPowers() = default;
  UnitPowers(double its_number) : number(its_number) {}
  /// @param unit as metrics have it: "1", "m", "rad/s^2", "m^-6 s^3"
  explicit UnitPowers(std::string_view unit);

  std::array<double, 3> power = {};
  std::optional<double> number;  ///< a constant of the formula
  bool lost = false;             ///< it adds what doesn't fit, or powers aren't known

  /// The unit's text; nullopt where it is lost, or has broken powers.
  [[nodiscard]] std::optional<std::string> text() const;

  [[nodiscard]] bool is_plain() const { return power == std::array<double, 3>{}; }

  [[nodiscard]] UnitPowers times(double exponent) const {
    UnitPowers unit = of(lost);
    for (std::size_t i = 0; i < 3; ++i) unit.power[i] = exponent * power[i];
    return unit;
  }
  [[nodiscard]] static UnitPowers of(bool is_lost) {
    UnitPowers unit;
    unit.lost = is_lost;
    return unit;
  }
  /// What only a bare number can be put into.
  [[nodiscard]] UnitPowers of_plain() const { return of(lost || !is_plain()); }

  friend UnitPowers operator-(const UnitPowers& a) {
    UnitPowers unit = a;
    if (a.number) unit.number = -*a.number;
    return unit;
  }
  friend UnitPowers operator+(const UnitPowers& a, const UnitPowers& b) {
    if (a.number) return b.number ? UnitPowers(*a.number + *b.number) : b;
    if (b.number) return a;
    UnitPowers unit = a;
    unit.lost = a.lost || b.lost || a.power != b.power;
    return unit;
  }
  friend UnitPowers operator-(const UnitPowers& a, const UnitPowers& b) {
    return a + -b;
  }
  friend UnitPowers operator*(const UnitPowers& a, const UnitPowers& b) {
    if (a.number && b.number) return *a.number * *b.number;
    UnitPowers unit = of(a.lost || b.lost);
    for (std::size_t i = 0; i < 3; ++i) unit.power[i] = a.power[i] + b.power[i];
    return unit;
  }
  friend UnitPowers operator/(const UnitPowers& a, const UnitPowers& b) {
    if (a.number && b.number) return *a.number / *b.number;
    return a * b.times(-1);
  }
  friend UnitPowers sqrt(const UnitPowers& a) {
    return a.number ? UnitPowers(std::sqrt(*a.number)) : a.times(0.5);
  }
  friend UnitPowers pow(const UnitPowers& a, const UnitPowers& b) {
    if (a.number && b.number) return std::pow(*a.number, *b.number);
    if (b.number) return a.times(*b.number);
    return of(a.lost || b.lost || !a.is_plain() || !b.is_plain());
  }
  friend UnitPowers exp(const UnitPowers& a) { return a.of_plain(); }
  friend UnitPowers log(const UnitPowers& a) { return a.of_plain(); }
  friend UnitPowers log10(const UnitPowers& a) { return a.of_plain(); }
  friend UnitPowers sin(const UnitPowers& a) { return of_angle(a); }
  friend UnitPowers cos(const UnitPowers& a) { return of_angle(a); }
  /// rad, as the angle that it is.
  friend UnitPowers atan2(const UnitPowers& a, const UnitPowers& b) {
    if (a.number && b.number) return std::atan2(*a.number, *b.number);
    UnitPowers unit = of((a + b).lost);
    unit.power = {0, 1, 0};
    return unit;
  }
  friend UnitPowers abs(const UnitPowers& a) { return a; }
  friend UnitPowers min(const UnitPowers& a, const UnitPowers& b) { return a + b; }
  friend UnitPowers max(const UnitPowers& a, const UnitPowers& b) { return a + b; }

 private:
  [[nodiscard]] static UnitPowers of_angle(const UnitPowers& a) {
    const bool angle = a.power == std::array<double, 3>{0, 1, 0};
    return angle ? of(a.lost) : a.of_plain();
  }
};

}  // namespace delos
