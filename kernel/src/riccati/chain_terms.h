// Closed forms of the scalar chain's steady state at dt = 1.
//
// Everything is a function of one number, e ∝ 1/ρ with ρ = dt^(2k−1) λ, so that the
// limits of good and of bad measurements are both plain: e → 0 and e → ∞. The Riccati
// equation is a spectral factorisation,
//
//     1 + λ H (zI − A)⁻¹ Q (z⁻¹I − Aᵀ)⁻¹ Hᵀ = (1 + λP_00) g(z) g(1/z),
//
// which the bilinear variable z = (1 + s)/(1 − s) turns into one of real polynomials in
// s². Matching coefficients gives the expressions below. Q and the covariances then
// follow from the gains and from the rows of P = A Π Aᵀ + Q that hold them.
#pragma once

#include <cmath>

#include "delos/riccati/spectral.h"

namespace delos::riccati {

/// f_ij and ∂f_ij/∂e at dt = 1, the upper triangle by rows: 00, 01, 02, 11, 12, 22.
template <int kOrder>
struct ChainTerms {
  double value[kOrder * (kOrder + 1) / 2];
  double slope[kOrder * (kOrder + 1) / 2];
};

/// e = kChainScale / ρ.
template <int kOrder>
inline constexpr double kChainScale = kOrder == 3 ? 64.0 : 4.0;

/// k = 1, e = 4/ρ, s = √(1 + e):  P = (1 + s)/2,  Π = P − 1 = e/(2 (1 + s)).
template <bool kSlopes>
inline ChainTerms<1> chain_terms_1(double e, CovarianceKind kind) {
  ChainTerms<1> f{};
  const double s = std::sqrt(1 + e);
  f.value[0] = kind == CovarianceKind::prior ? (1 + s) / 2 : e / (2 * (1 + s));
  if constexpr (kSlopes) f.slope[0] = 1 / (4 * s);
  return f;
}

/// k = 2, e = 4/ρ, v = √(1/12 + e), u = 1/3 + v, r = √u, c = (u + r)/2 + 1/12:
///
///     P_00 = r c,  P_01 = c,  P_11 = r + 1/2,  1/(1 + λP_00) = e/(4c²),  Π_11 = r −
///     1/2
///
/// In Kalata's gains β = 1/c and α = r/c. r ≥ 0.788, so r − 1/2 loses no more than a
/// bit.
template <bool kSlopes>
inline ChainTerms<2> chain_terms_2(double e, CovarianceKind kind) {
  ChainTerms<2> f{};
  const double v = std::sqrt(1.0 / 12 + e);
  const double u = 1.0 / 3 + v;
  const double r = std::sqrt(u);
  const double c = (u + r) / 2 + 1.0 / 12;
  const bool prior = kind == CovarianceKind::prior;
  f.value[1] = prior ? c : e / (4 * c);
  f.value[0] = r * f.value[1];
  f.value[2] = prior ? r + 0.5 : r - 0.5;
  if constexpr (kSlopes) {
    const double du = 1 / (2 * v), dr = du / (2 * r), dc = (du + dr) / 2;
    // Below, 1/e outweighs c′/c at least twofold: c grows no faster than √e.
    f.slope[1] = prior ? dc : f.value[1] * (1 / e - dc / c);
    f.slope[0] = dr * f.value[1] + r * f.slope[1];
    f.slope[2] = dr;
  }
  return f;
}

/// The positive root w of w⁴/4 − w² − 2 a w − 2/15 = 0 for a ≥ √(2/15).
///
/// w = 2t + 2/(3t) + O(t⁻³), t = ∛a, is its expansion for large a. With a last term
/// fitted to the other end it is nowhere more than 0.17 % off; a step of Halley's
/// iteration leaves 2e-8, the second nothing.
inline double chain_root_3(double a) {
  const double t = std::cbrt(a), p = 1 / t;
  double w = 2 * t + p * (2.0 / 3 - 0.0085 * (p * p) * (p * p));
  for (int step = 0; step < 2; ++step) {
    const double w2 = w * w;
    const double value = w * (w * (w2 / 4 - 1) - 2 * a) - 2.0 / 15;
    const double slope = w * (w2 - 2) - 2 * a;
    const double curve = 3 * w2 - 2;
    w -= value * slope / (slope * slope - value * curve / 2);
  }
  return w;
}

/// k = 3, e = 64/ρ. The Hurwitz factor 1 + w s + (w²/2 − 1) s² + a s³ has
/// a = √(e + 2/15) and w of chain_root_3(). With b = w + w²/2 and g = b + a:
///
///     P_00 = (b (b + 2a) + 2/15)/64,  P_01 = w g/16,  P_02 = g/8,
///     P_11 = (w³/2 + w² − a)/8,  P_12 = w²/8 + w/4 + 1/12,  P_22 = w/2 + 1/2,
///     1/(1 + λP_00) = e/g²,
///     Π_11 = (w³/2 − w² − a)/8,  Π_12 = w²/8 − w/4 + 1/12,  Π_22 = w/2 − 1/2
///
/// w ≥ 2.31 and w³/2 ≥ 4a: the differences lose a decimal digit at most.
template <bool kSlopes>
inline ChainTerms<3> chain_terms_3(double e, CovarianceKind kind) {
  ChainTerms<3> f{};
  const double a = std::sqrt(e + 2.0 / 15);
  const double w = chain_root_3(a);
  const double b = w * (1 + w / 2), g = b + a;
  const bool prior = kind == CovarianceKind::prior;
  const double sign = prior ? 1 : -1;
  const double keep = prior ? 1 : e / (g * g);
  f.value[0] = keep * (b * (b + 2 * a) + 2.0 / 15) / 64;
  f.value[1] = keep * w * g / 16;
  f.value[2] = keep * g / 8;
  f.value[3] = (w * w * (w / 2 + sign) - a) / 8;
  f.value[4] = w * (w / 8 + sign / 4) + 1.0 / 12;
  f.value[5] = (w + sign) / 2;
  if constexpr (kSlopes) {
    // w′ from the quartic: (w³ − 2w − 2a) w′ = 2 w a′.
    const double da = 1 / (2 * a);
    const double dw = 2 * w * da / (w * (w * w - 2) - 2 * a);
    const double db = (1 + w) * dw, dg = db + da;
    const double dkeep = prior ? 0 : 1 / e - 2 * dg / g;  // (ln keep)′
    f.slope[0] = keep * (db * (b + a) + b * da) / 32 + f.value[0] * dkeep;
    f.slope[1] = f.value[1] * (dw / w + dg / g + dkeep);
    f.slope[2] = f.value[2] * (dg / g + dkeep);
    f.slope[3] = (w * (1.5 * w + 2 * sign) * dw - da) / 8;
    f.slope[4] = (w + sign) * dw / 4;
    f.slope[5] = dw / 2;
  }
  return f;
}

template <int kOrder, bool kSlopes>
inline ChainTerms<kOrder> chain_terms(double e, CovarianceKind kind) {
  if constexpr (kOrder == 1) return chain_terms_1<kSlopes>(e, kind);
  if constexpr (kOrder == 2) return chain_terms_2<kSlopes>(e, kind);
  if constexpr (kOrder == 3) return chain_terms_3<kSlopes>(e, kind);
}

/// Continuous measurement at rate λ = 1, where the poles are Butterworth's:
///
///     f_ij(λ) = f_ij(1) ω^−(2k−1−i−j),  ω = λ^(1/2k),
///
/// which solves F P + P Fᵀ + Q = λ P e₀ e₀ᵀ P as can be checked by hand.
template <int kOrder>
inline ChainTerms<kOrder> continuous_terms() {
  if constexpr (kOrder == 1) return {{1}, {}};
  if constexpr (kOrder == 2) return {{std::sqrt(2.0), 1, std::sqrt(2.0)}, {}};
  if constexpr (kOrder == 3) return {{2, 2, 1, 3, 2, 2}, {}};
}

/// x^p for the small whole p that occur.
inline double power(double x, int p) {
  double y = 1;
  for (int i = 0; i < p; ++i) y *= x;
  return y;
}

/// ω = λ^(1/2k), rad/s.
template <int kOrder>
inline double butterworth_radius(double rate) {
  if constexpr (kOrder == 1) return std::sqrt(rate);
  if constexpr (kOrder == 2) return std::sqrt(std::sqrt(rate));
  if constexpr (kOrder == 3) return std::cbrt(std::sqrt(rate));
}

/// f_ij(λ), and with kSlopes f_ij′(λ), in SI units.
template <int kOrder, bool kSlopes>
inline ChainTerms<kOrder> chain_values(const Sampling& sampling, double lambda,
                                       CovarianceKind kind) {
  constexpr int kTop = 2 * kOrder - 1;
  ChainTerms<kOrder> f;
  double length, e_over_lambda = 0;  // the unit of time, and −∂e/∂λ
  if (sampling.continuous) {
    f = continuous_terms<kOrder>();
    length = 1 / butterworth_radius<kOrder>(lambda);
  } else {
    length = sampling.dt;
    const double e = kChainScale<kOrder> / (power(length, kTop) * lambda);
    f = chain_terms<kOrder, kSlopes>(e, kind);
    e_over_lambda = e / lambda;
  }
  double scale[kTop + 1] = {1};  // powers of the unit of time
  for (int p = 1; p <= kTop; ++p) scale[p] = scale[p - 1] * length;
  for (int i = 0, entry = 0; i < kOrder; ++i) {
    for (int j = i; j < kOrder; ++j, ++entry) {
      const int exponent = kTop - i - j;
      f.value[entry] *= scale[exponent];
      if constexpr (kSlopes) {
        f.slope[entry] = sampling.continuous
                             ? -exponent * f.value[entry] / (2 * kOrder * lambda)
                             : -e_over_lambda * f.slope[entry] * scale[exponent];
      }
    }
  }
  return f;
}

}  // namespace delos::riccati
