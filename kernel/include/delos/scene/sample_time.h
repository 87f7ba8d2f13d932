// How long a device samples: what that does to its noise, and to its rate.
//
// Source: Welch, Allen, Ilie, Bishop (2007), §3.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "delos/api.h"

namespace delos {

/// How the variance R of a reading falls with the time τ that it samples.
enum class NoiseLaw {
  constant,    ///< the same for any τ
  inverse,     ///< c/τ: white noise, averaged or integrated
  samples,     ///< c/s: the mean of s = τ·f samples at a frequency f, at least one
  photon,      ///< a/τ + b/τ²: photons, and reading a signal out that grows with τ
  photodiode,  ///< G(τ)²: light minus dark of a photodiode with one pole
  table,       ///< fitted to variances measured on a bench
  expression,  ///< by a formula of tau
};

/// A variance that was measured on a bench, in any unit.
struct BenchReading {
  double exposure = 0;  ///< τ, seconds, > 0
  double variance = 0;  ///< R, > 0
  friend bool operator==(const BenchReading&, const BenchReading&) = default;
};

/// R as a function of the sample time, relative to what the device's parameters say,
/// which is R of one sample time.
struct NoiseOverTime {
  NoiseLaw law = NoiseLaw::constant;
  double at = 0;         ///< the sample time that the parameters are of, seconds, > 0
  double read = 0;       ///< photon: what part of R reading out has at `at`, 0 to 1
  double frequency = 0;  ///< samples: f, Hz, > 0
  double bandwidth = 0;  ///< photodiode: of the pole, Hz, > 0
  double gap = 0;  ///< photodiode: between the light and the dark window, s, ≥ 0
  std::vector<BenchReading> table;  ///< ascending, three or more
  std::string expression;           ///< R of tau, seconds, in any unit
  friend bool operator==(const NoiseOverTime&, const NoiseOverTime&) = default;
};

/// R = a + b/τ + c/τ², all three ≥ 0, of the least squares of relative deviations.
struct BenchFit {
  double constant = 0, inverse = 0, inverse_square = 0;
  double error = 0;  ///< root of the mean square relative deviation
};

/// @pre three readings or more
[[nodiscard]] DELOS_API BenchFit fit_bench(std::span<const BenchReading> readings);

/// RMS noise of a photodiode's reading, the difference of a light and a dark window of
/// T seconds each with a gap between, over that of its amplifier's spot noise of 1
/// V/√Hz:
///
///     G(T) = √( (2/T²) (D1 − D2 − D3) ),   a = π f0
///     D1 = [e^(−2aT) + 2aT − 1]/(2a)
///     D2 = [1 − (1 + 2aT) e^(−2aT)] e^(−2aT0)/(4a)
///     D3 = e^(−2aT0) [e^(−4aT) + 2aT e^(−2aT) − e^(−2aT)]/(4a)
///
/// Source: Allen (2007), dissertation, Appendix C, after Chi (1995), with the strings
/// of
///         the listing in a form that doesn't overflow.
/// @param window T, seconds, > 0; @param bandwidth f0, Hz; @param gap T0, seconds
[[nodiscard]] DELOS_API double photodiode_gain(double window, double bandwidth,
                                               double gap);

/// R(τ)/R(at). Infinite where τ is 0 but for laws that are finite there; NaN where an
/// expression has no positive value.
[[nodiscard]] DELOS_API double noise_ratio(const NoiseOverTime& noise, double exposure);

/// Empty where the expression can be read, else what is wrong with it.
[[nodiscard]] DELOS_API std::string expression_problem(const NoiseOverTime& noise);

/// What an update takes: δt = n τ + τ_p + τ_i.
struct Timing {
  double windows = 1;     ///< n, windows of τ an update, > 0
  double processing = 0;  ///< τ_p, seconds, ≥ 0
  double idle = 0;        ///< τ_i, seconds, ≥ 0
  friend bool operator==(const Timing&, const Timing&) = default;
};

/// δt, seconds.
[[nodiscard]] inline double period_of(const Timing& timing, double exposure) {
  return timing.windows * exposure + timing.processing + timing.idle;
}

}  // namespace delos
