// Numbers that carry their slopes: a formula written once gives its derivatives.
//
//   x = a + Σ_k d_k ε_k,   ε_i ε_j = 0,   f(x) = f(a) + f′(a) Σ_k d_k ε_k
//
// Dual<double, n> has the derivatives along n directions, Dual<Dual<double, n>, n> the
// second ones, too. Source: Griewank, Walther (2008), Evaluating Derivatives, 2nd ed.,
// §3.1.
#pragma once

#include <cmath>

namespace delos {

template <class S, int n>
struct Dual;

/// The plain number in it.
[[nodiscard]] inline double plain(double x) { return x; }
template <class S, int n>
[[nodiscard]] double plain(const Dual<S, n>& x) {
  return plain(x.value);
}

/// The one of two.
[[nodiscard]] inline double chosen(bool first, double x, double y) {
  return first ? x : y;
}

/// A number and its slopes along n directions.
template <class S, int n>
struct Dual {
  S value{};
  S slope[n]{};

  Dual() = default;
  // Implicit, so that formulas mix them with plain numbers.
  Dual(double constant) : value(constant) {}  // NOLINT(google-explicit-constructor)
  /// @param k the direction along which it grows as fast as one goes; −1: constant
  explicit Dual(const S& number, int k) : value(number) {
    if (k >= 0) slope[k] = 1.0;
  }

  /// f(x) of its value f(a) and derivative f′(a).
  [[nodiscard]] Dual chained(const S& f, const S& derivative) const {
    return with(f, [&](int k) { return slope[k] * derivative; });
  }
  /// Of a value and the slope along each direction k.
  template <class Slope>
  [[nodiscard]] static Dual with(const S& number, Slope&& along) {
    Dual x(number, -1);
    for (int k = 0; k < n; ++k) x.slope[k] = along(k);
    return x;
  }

  /// One of two, number by number: compilers turn it into vector instructions.
  friend Dual chosen(bool first, const Dual& x, const Dual& y) {
    return with(chosen(first, x.value, y.value),
                [&](int k) { return chosen(first, x.slope[k], y.slope[k]); });
  }

  friend Dual operator-(const Dual& x) {
    return with(-x.value, [&](int k) { return -x.slope[k]; });
  }
  friend Dual operator+(const Dual& x, const Dual& y) {
    return with(x.value + y.value, [&](int k) { return x.slope[k] + y.slope[k]; });
  }
  friend Dual operator+(const Dual& x, double y) {
    return with(x.value + y, [&](int k) { return x.slope[k]; });
  }
  friend Dual operator+(double x, const Dual& y) { return y + x; }
  friend Dual operator-(const Dual& x, const Dual& y) {
    return with(x.value - y.value, [&](int k) { return x.slope[k] - y.slope[k]; });
  }
  friend Dual operator-(const Dual& x, double y) { return x + (-y); }
  friend Dual operator-(double x, const Dual& y) { return x + (-y); }
  friend Dual operator*(const Dual& x, const Dual& y) {
    return with(x.value * y.value,
                [&](int k) { return x.slope[k] * y.value + x.value * y.slope[k]; });
  }
  friend Dual operator*(const Dual& x, double y) {
    return with(x.value * y, [&](int k) { return x.slope[k] * y; });
  }
  friend Dual operator*(double x, const Dual& y) { return y * x; }
  // (x/y)′ = (x′ − (x/y) y′)/y
  friend Dual operator/(const Dual& x, const Dual& y) {
    const S inverse = 1.0 / y.value, q = x.value / y.value;
    return with(q, [&](int k) { return (x.slope[k] - q * y.slope[k]) * inverse; });
  }
  friend Dual operator/(const Dual& x, double y) {
    return with(x.value / y, [&](int k) { return x.slope[k] / y; });
  }
  friend Dual operator/(double x, const Dual& y) {
    const S q = x / y.value;
    return y.chained(q, -q / y.value);
  }

  friend Dual sqrt(const Dual& x) {
    using std::sqrt;
    const S root = sqrt(x.value);
    return x.chained(root, 0.5 / root);
  }
  friend Dual exp(const Dual& x) {
    using std::exp;
    const S value = exp(x.value);
    return x.chained(value, value);
  }
  friend Dual log(const Dual& x) {
    using std::log;
    return x.chained(log(x.value), 1.0 / x.value);
  }
  friend Dual log10(const Dual& x) {
    using std::log10;
    return x.chained(log10(x.value), 1.0 / (x.value * std::log(10.0)));
  }
  friend Dual sin(const Dual& x) {
    using std::cos, std::sin;
    return x.chained(sin(x.value), cos(x.value));
  }
  friend Dual cos(const Dual& x) {
    using std::cos, std::sin;
    return x.chained(cos(x.value), -sin(x.value));
  }
  // ∂atan2(y, x) = (x ∂y − y ∂x)/(x² + y²)
  friend Dual atan2(const Dual& y, const Dual& x) {
    using std::atan2;
    const S square = x.value * x.value + y.value * y.value;
    const S of_y = x.value / square, of_x = y.value / square;
    return with(atan2(y.value, x.value),
                [&](int k) { return of_y * y.slope[k] - of_x * x.slope[k]; });
  }
  /// The slope at 0 is that from above.
  friend Dual abs(const Dual& x) { return chosen(plain(x) < 0, -x, x); }
  /// ∂(a^b) = b a^(b−1) ∂a + a^b log a ∂b, where a must be above 0 only if b varies.
  friend Dual pow(const Dual& a, const Dual& b) {
    using std::log, std::pow;
    const S value = pow(a.value, b.value);
    return with(value, [&](int k) {
      S slope{};
      if (!(plain(a.slope[k]) == 0))
        slope = slope + b.value * pow(a.value, b.value - 1.0) * a.slope[k];
      if (!(plain(b.slope[k]) == 0)) slope = slope + value * log(a.value) * b.slope[k];
      return slope;
    });
  }
  /// The first of equals.
  friend Dual min(const Dual& x, const Dual& y) {
    return chosen(plain(y) < plain(x), y, x);
  }
  friend Dual max(const Dual& x, const Dual& y) {
    return chosen(plain(x) < plain(y), y, x);
  }
};

}  // namespace delos
