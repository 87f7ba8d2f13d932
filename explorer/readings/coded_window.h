// An exposure in pieces: a shutter that opens and closes by a code (flutter shutter).
//
// The code's digits are chops of one length c, 1 where light comes in. A reading is the
// mean over the open ones. Of a coordinate of order k, driven by white noise q, whose
// state at the end is known, the reading misses by a variance
//
//     R_η = q ∫ g(b)² db,   g(b) = ∫_{a > b} p(a) (a − b)^(k−1)/(k−1)! da
//
// with p the open time's density and a, b ages; for one open window this is
// q τ^(2k−1)/((2k+1) (k!)²). A code lets in less light than a whole window, and so is
// noisier, but its spectrum needn't vanish anywhere, so that a smear can be undone.
//
// Source: R. Raskar, A. Agrawal, J. Tumblin: Coded exposure photography: motion
// deblurring using fluttered shutter, ACM Trans. Graphics 25(3), 795-804, 2006.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace delos::readings {

struct CodedWindow {
  std::vector<bool> open;  ///< first to last, one or more of them open
  double chop = 0;         ///< seconds each, > 0

  [[nodiscard]] double duration() const {
    return chop * static_cast<double>(open.size());
  }
  /// Seconds of light.
  [[nodiscard]] double light() const;
};

/// @param digits 0 and 1, up to 1000
/// @returns nullopt where they aren't, or none is open
[[nodiscard]] std::optional<std::vector<bool>> code_of(const std::string& digits);

/// h: what state j, x⁽ʲ⁾ at the end, has in the mean: E[(−a)^j]/j!. s^j
[[nodiscard]] double lever_of(const CodedWindow& window, int j);

/// R_η for q = 1: seconds^(2k−1).
/// @param order k: 1, 2 or 3
[[nodiscard]] double motion_of(const CodedWindow& window, int order);

/// How far the light is spread while something moves at 1 m/s: the standard deviation
/// of the open time, s.
[[nodiscard]] double spread_of(const CodedWindow& window);

/// The spectrum |Σ exp(−2πi f n)| over the open chops, over their number, at its least
/// for f up to half a cycle a chop; and the noise gain of undoing the smear, the mean
/// of 1/|·|² over so many frequencies as twice the chops. Infinite where it vanishes.
struct Smear {
  double least = 0;
  double noise_gain = 0;
};
[[nodiscard]] Smear smear_of(const CodedWindow& window);

}  // namespace delos::readings
