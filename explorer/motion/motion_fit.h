// The motion model of a recorded track: order, q of each axis, and whether it fits.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "motion/chain_fit.h"
#include "recordings/recording.h"

namespace delos::motion {

/// Which part of a track counts, and how often a device would see it.
struct FitQuestion {
  double interval = 0;                      ///< seconds between updates; 0: each frame
  double from = 0;                          ///< seconds after the first frame
  std::optional<double> to = std::nullopt;  ///< likewise
  double significance = 0.01;               ///< below it, innovations aren't white
};

/// One order over all axes.
struct OrderFit {
  std::array<ChainFit, 3> axes;  ///< x, y, z
  double bayes = 0;              ///< −2 log L + p log n, p = 6
  double p_value = 0;            ///< of Ljung–Box over all axes
};

struct MotionFit {
  std::string track;
  double dt = 0;           ///< seconds between the frames that count
  std::size_t frames = 0;  ///< that count, gaps among them
  std::size_t gaps = 0;
  std::array<OrderFit, kOrders> orders;  ///< P, PV, PVA
  int likeliest = 0;                     ///< the index of the least BIC
  /// The index of the one to take: the likeliest of those whose innovations are white,
  /// and of all where none's are.
  int best = 0;
  bool fits = false;   ///< its innovations are white
  bool still = false;  ///< no axis moves
};

/// @returns the fit, or a sentence that says why there is none
[[nodiscard]] std::variant<MotionFit, std::string> fit_motion(
    const recordings::Track& track, double period, const FitQuestion& question);

/// "position_velocity" of order 2, …
[[nodiscard]] const char* type_of_order(int order);

/// A block for a scene, YAML, with what it is from in comments.
/// @param source of the numbers, such as a file's name
[[nodiscard]] std::string motion_block(const MotionFit& fit, const std::string& source);

}  // namespace delos::motion
