// Noise of a lateral-effect photodiode: how well one axis tells where the light is.
#pragma once

namespace hiball {

/// A photodiode axis with its two amplifiers. SI units.
struct Photodiode {
  double feedback;        ///< rf of the transimpedance amplifiers, Ω
  double interelectrode;  ///< Rie between the ends of the axis, Ω
  double voltage_noise;   ///< vn of an amplifier, V/√Hz
  double current_noise;   ///< in of an amplifier, A/√Hz
  double bandwidth;       ///< f0 of the one-pole filter, Hz
  double temperature;     ///< K
  double current;         ///< K: photocurrent of an LED at 1 m, head on, A·m²
  double gap;             ///< T0 between the light and the dark window, s
};

/// How the two ends' noises make the noise of their normalised difference.
enum class Sum {
  linear,       ///< they add up: the worst case, as in the source
  independent,  ///< their squares add up
};

/// What a window of light and an equally long one of darkness make of white noise of
/// one volt per root hertz, V. Source: the strings of the listing, in a form that
/// doesn't overflow.
///
///   D1 = [e^(−2aT) + 2aT − 1]/(2a)      D2 = [1 − (1+2aT) e^(−2aT)] e^(−2aT0)/(4a)
///   D3 = e^(−2aT0) [e^(−4aT) + 2aT e^(−2aT) − e^(−2aT)]/(4a)      a = π f0
///   G(T) = √((2/T²)(D1 − D2 − D3))
///
/// @param light T, s, > 0
[[nodiscard]] double window_gain(const Photodiode& diode, double light);

/// Standard deviation of the normalised position x = (I₁ − I₂)/(I₁ + I₂).
///
///   I = K cos φ/d²,   I₁,₂ = I (1 ± x)/2,   S₁,₂ = rf I₁,₂,   N₁,₂ = G·v₁,₂
///   X = 2 (N₁S₂ + N₂S₁)/(S₁ + S₂)²          Sum::linear
///   X = 2 √((N₁S₂)² + (N₂S₁)²)/(S₁ + S₂)²   Sum::independent
///
/// v₁,₂ is the root sum of squares of shot noise rf√(2 q_e I₁,₂), the own amplifier's
/// voltage noise vn (1 + rf/Rie), the other one's vn rf/Rie, current noise rf in, and
/// thermal noise of Rie, rf√(4kT/Rie), and of rf, √(4kT rf).
/// @param gain window_gain() of the light window
/// @param x of the light's centre, −1 to 1
/// @param cosine of the angle φ between the LED's axis and the line to the lens, > 0
/// @param distance d, m
/// Source: Allen (2007), Comparing the expected performance of tracking and motion
/// capture systems, UNC Chapel Hill, Appendix C; after Chi (1995), Noise modeling and
/// design of optical trackers.
[[nodiscard]] double position_noise(const Photodiode& diode, Sum sum, double gain,
                                    double x, double cosine, double distance);

}  // namespace hiball
