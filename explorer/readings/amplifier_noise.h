// The noise of a light sensor from its electronics: each source, and what a window of
// light less one of darkness leaves of them all.
//
// A current I flows through the feedback resistance rf of an amplifier, whose input is
// joined to that of a second one by a resistance Rie: two ends of a position-sensing
// diode. Densities at the output, V/√Hz:
//
//     shot                 rf √(2 e I)
//     own amplifier        vn (1 + rf/Rie)
//     other amplifier      vn rf/Rie
//     input current        rf in
//     heat of Rie          rf √(4 k T/Rie)
//     heat of rf           √(4 k T rf)
//
// vn² and in² are larger by 1 + fc/f below a corner fc. Rie infinite: a diode of one
// end.
//
// Source: B. D. Allen, dissertation, 2007, Appendix C, after V. Chi: Noise modeling and
// design of optical trackers, 1995; 1/f corners: C. D. Motchenbacher, J. A. Connelly:
// Low-noise electronic system design, 1993, chapter 1.
#pragma once

#include <array>

namespace delos::readings {

/// SI units.
struct Amplifier {
  double feedback = 2e5;         ///< rf, Ω, > 0
  double interelectrode = 7500;  ///< Rie, Ω, > 0; infinite: none
  double voltage = 4.5e-9;       ///< vn, V/√Hz, ≥ 0
  double current = 6e-13;        ///< in, A/√Hz, ≥ 0
  double voltage_corner = 0;     ///< fc of vn, Hz, ≥ 0
  double current_corner = 0;     ///< fc of in, Hz, ≥ 0
  double temperature = 300;      ///< K, ≥ 0
  double bandwidth = 1.6e5;      ///< f0 of its one-pole filter, Hz, > 0
  double gap = 2e-5;             ///< T0 from the light to the dark window, s, ≥ 0
};

inline constexpr int kSources = 6;
inline constexpr const char* kSourceNames[kSources] = {
    "shot",          "own amplifier", "other amplifier",
    "input current", "heat of Rie",   "heat of rf"};

/// One source at the output.
struct SourceNoise {
  double density = 0;  ///< above all corners, V/√Hz
  double rms = 0;      ///< after the windows, V
};

/// @param current I, A, ≥ 0
/// @param window T of light, and as long of darkness, s, > 0
/// @cost where there is a corner, some 10⁴ (T + T0)/T evaluations
[[nodiscard]] std::array<SourceNoise, kSources> noise_of(const Amplifier& amplifier,
                                                         double current, double window);

/// Of a resistance over a bandwidth: √(4 k T R B), V.
[[nodiscard]] double johnson_noise(double resistance, double temperature,
                                   double bandwidth);
/// Of a current over a bandwidth: √(2 e I B), A.
[[nodiscard]] double shot_noise(double current, double bandwidth);

/// What both ends together say of where the light is.
struct PositionNoise {
  std::array<double, 2> current{};  ///< I₁,₂ = I (1 ± x)/2, A
  std::array<std::array<SourceNoise, kSources>, 2> sources{};
  std::array<double, 2> rms{};  ///< N₁,₂, V
  double linear = 0;  ///< X_n = 2 (N₁S₂ + N₂S₁)/(S₁ + S₂)², as published
  double independent = 0;  ///< 2 √((N₁S₂)² + (N₂S₁)²)/(S₁ + S₂)²
};

/// @param current I of both ends, A, > 0
/// @param x where the light is, −1 to 1
/// @param readings that are averaged, ≥ 1
[[nodiscard]] PositionNoise position_noise(const Amplifier& amplifier, double current,
                                           double x, double window, double readings);

}  // namespace delos::readings
