// Numbers with a slope, for exact derivatives of expressions.
#pragma once

#include <cmath>

namespace delos {

/// value + slope ε with ε² = 0. Source: Griewank, Walther (2008), Evaluating
/// Derivatives, 2nd ed., §3.1.
struct Dual {
  Dual() = default;
  Dual(double number, double its_slope = 0) : value(number), slope(its_slope) {}

  double value = 0, slope = 0;

  friend Dual operator-(Dual a) { return {-a.value, -a.slope}; }
  friend Dual operator+(Dual a, Dual b) {
    return {a.value + b.value, a.slope + b.slope};
  }
  friend Dual operator-(Dual a, Dual b) {
    return {a.value - b.value, a.slope - b.slope};
  }
  friend Dual operator*(Dual a, Dual b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend Dual operator/(Dual a, Dual b) {
    const double value = a.value / b.value;
    return {value, (a.slope - value * b.slope) / b.value};
  }
  friend Dual sqrt(Dual a) {
    const double root = std::sqrt(a.value);
    return {root, a.slope / (2 * root)};
  }
  friend Dual exp(Dual a) {
    const double value = std::exp(a.value);
    return {value, value * a.slope};
  }
  friend Dual log(Dual a) { return {std::log(a.value), a.slope / a.value}; }
  friend Dual log10(Dual a) {
    return {std::log10(a.value), a.slope / (a.value * std::log(10.0))};
  }
  friend Dual sin(Dual a) { return {std::sin(a.value), std::cos(a.value) * a.slope}; }
  friend Dual cos(Dual a) { return {std::cos(a.value), -std::sin(a.value) * a.slope}; }
  friend Dual abs(Dual a) { return a.value < 0 ? -a : a; }
  /// ∂(a^b) = b a^(b−1) ∂a + a^b log a ∂b, where a must be above 0 only if b varies.
  friend Dual pow(Dual a, Dual b) {
    const double value = std::pow(a.value, b.value);
    double slope = 0;
    if (a.slope != 0) slope += b.value * std::pow(a.value, b.value - 1) * a.slope;
    if (b.slope != 0) slope += value * std::log(a.value) * b.slope;
    return {value, slope};
  }
  friend Dual min(Dual a, Dual b) { return b.value < a.value ? b : a; }
  friend Dual max(Dual a, Dual b) { return a.value < b.value ? b : a; }
};

}  // namespace delos
