// The motion of a target from a record of one coordinate: which chain, and how vivid.
//
// The coordinate is x of a chain of order k, driven by white noise q (model/motion.h),
// seen every dt seconds with white noise of variance r. (q, r) are those of the
// greatest likelihood, which a Kalman filter has from its innovations ν and their
// variances S:
//
//     −2 log L = Σ log(2π S) + ν²/S
//
// Source: Schweppe (1965), IEEE Trans. Information Theory 11(1), 61–70; the scale that
// is solved for in closed form: Harvey (1989), Forecasting, Structural Time Series
// Models and the Kalman Filter, §3.4.
#pragma once

#include <array>
#include <span>

namespace delos::motion {

/// A number and where it lies in 95 of 100 cases.
struct Estimate {
  double value = 0;
  double low = 0, high = 0;
};

/// Where the likelihood is greatest.
enum class Edge {
  none,       ///< inside
  no_noise,   ///< r isn't distinguished from 0
  no_motion,  ///< q isn't distinguished from 0
};

/// The best chain of one order.
struct ChainFit {
  int order = 0;
  Estimate q;  ///< m²/s^(2k−1)
  Estimate r;  ///< m²
  Edge edge = Edge::none;
  double minus_2_log_likelihood = 0;
  /// Of the standardised innovations: Q = n (n+2) Σ ρ_j²/(n−j) over so many lags, and
  /// how likely as large a one is where they are white. Source: Ljung, Box (1978),
  /// Biometrika 65(2), 297–303.
  double ljung_box = 0, p_value = 0;
  int lags = 0;
  double first_correlation = 0;  ///< ρ_1
};

inline constexpr int kOrders = 3;

/// Fits of P, PV and PVA, over the same innovations.
/// @param z a value a frame, metres; NaN where it wasn't seen
/// @param dt seconds between frames
/// @pre kFewestFrames or more are seen
/// @cost some 30 filters a chain over all frames, no heap beyond their innovations
[[nodiscard]] std::array<ChainFit, kOrders> fit_chains(std::span<const double> z,
                                                       double dt);

inline constexpr int kFewestFrames = 60;

/// How likely as large a value of χ² is.
[[nodiscard]] double chi_squared_tail(double value, double degrees);

}  // namespace delos::motion
