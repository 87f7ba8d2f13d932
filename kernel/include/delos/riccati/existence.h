// Which conditions for a steady state a motion itself keeps.
#pragma once

#include "delos/api.h"
#include "delos/model/motion.h"

namespace delos {

/// Modes of a motion that no noise drives and that do not die out by themselves.
///
/// The Riccati equation has a stabilising solution exactly where (A, H) is detectable
/// and (A, Q^½) has no such mode *on* the unit circle; without any it is stabilizable.
/// Source: Lancaster, Rodman (1995), Algebraic Riccati Equations, ch. 16.
struct UndrivenModes {
  /// n×m, unit columns w with wᵀA in their span and wᵀQ = 0; m = 0: stabilizable.
  StateMatrix directions;
  bool on_circle = false;  ///< some |μ| is 1: what starts unknown is forgotten never
};

[[nodiscard]] DELOS_API UndrivenModes undriven_modes(const MotionStep& motion);

}  // namespace delos
