// Whether a formula can only rise, or only fall, when less is known.
#pragma once

#include <optional>

namespace delos {

/// A formula's part, to be worked with in place of a number: what is sure of its sign,
/// and which way it goes as P∞ grows.
struct Trend {
  enum class Sign { negative = -1, any = 0, positive = 1 };  ///< ≤ 0, any, ≥ 0
  enum class Way { falls, stays, rises, any };

  Trend() = default;
  Trend(double its_number)
      : sign(its_number >= 0 ? Sign::positive : Sign::negative), number(its_number) {}
  Trend(Sign its_sign, Way its_way) : sign(its_sign), way(its_way) {}

  Sign sign = Sign::any;
  Way way = Way::stays;
  std::optional<double> number;  ///< a constant of the formula

  [[nodiscard]] static Way turned(Way way) {
    return way == Way::falls ? Way::rises : way == Way::rises ? Way::falls : way;
  }
  [[nodiscard]] static Sign turned(Sign sign) {
    return static_cast<Sign>(-static_cast<int>(sign));
  }
  /// Of what rises with both.
  [[nodiscard]] static Way both(Way a, Way b) {
    if (a == b || b == Way::stays) return a;
    return a == Way::stays ? b : Way::any;
  }
  [[nodiscard]] bool stays() const { return way == Way::stays; }
  /// Of a function that may do anything.
  [[nodiscard]] Trend anyhow() const {
    return {Sign::any, stays() ? Way::stays : Way::any};
  }
  [[nodiscard]] Trend inverse() const {
    if (sign == Sign::any) return anyhow();
    return {sign, turned(way)};
  }

  friend Trend operator-(const Trend& a) {
    Trend result(turned(a.sign), turned(a.way));
    if (a.number) result.number = -*a.number;
    return result;
  }
  friend Trend operator+(const Trend& a, const Trend& b) {
    if (a.number && b.number) return *a.number + *b.number;
    return {a.sign == b.sign ? a.sign : Sign::any, both(a.way, b.way)};
  }
  friend Trend operator-(const Trend& a, const Trend& b) { return a + -b; }
  friend Trend operator*(const Trend& a, const Trend& b) {
    if (a.number && b.number) return *a.number * *b.number;
    if (a.sign == Sign::negative) return -(-a * b);
    if (b.sign == Sign::negative) return -(a * -b);
    const bool of_known = a.sign == Sign::positive && b.sign == Sign::positive;
    if (of_known) return {Sign::positive, both(a.way, b.way)};
    if (a.stays() && b.stays()) return {Sign::any, Way::stays};
    if (a.stays() && a.sign == Sign::positive) return {Sign::any, b.way};
    if (b.stays() && b.sign == Sign::positive) return {Sign::any, a.way};
    return {Sign::any, Way::any};
  }
  friend Trend operator/(const Trend& a, const Trend& b) {
    if (a.number && b.number) return *a.number / *b.number;
    return a * b.inverse();
  }
  friend Trend sqrt(const Trend& a) { return {Sign::positive, a.way}; }
  friend Trend exp(const Trend& a) { return {Sign::positive, a.way}; }
  friend Trend log(const Trend& a) { return {Sign::any, a.way}; }
  friend Trend log10(const Trend& a) { return {Sign::any, a.way}; }
  friend Trend sin(const Trend& a) { return a.anyhow(); }
  friend Trend cos(const Trend& a) { return a.anyhow(); }
  friend Trend abs(const Trend& a) {
    if (a.sign == Sign::any) return {Sign::positive, a.anyhow().way};
    return a.sign == Sign::negative ? -a : a;
  }
  friend Trend pow(const Trend& a, const Trend& b) {
    if (!b.number || a.sign != Sign::positive)
      return {Sign::any, a.stays() && b.stays() ? Way::stays : Way::any};
    return {Sign::positive, *b.number >= 0 ? a.way : turned(a.way)};
  }
  friend Trend atan2(const Trend& a, const Trend& b) { return (a + b).anyhow(); }
  friend Trend min(const Trend& a, const Trend& b) { return a + b; }
  friend Trend max(const Trend& a, const Trend& b) { return a + b; }
};

}  // namespace delos
