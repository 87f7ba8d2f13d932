// From words to the noise that drives a motion: how fast something moves, and within
// which time that changes.
//
// The velocity (of order 1 and 2) or acceleration (of order 3) of something that keeps
// its speed and turns at random is along each axis a first-order Gauss–Markov process
// of variance σ² that forgets with a time constant T, and such a process is driven by
// white noise of density 2 σ²/T. A chain that is driven by the same noise does the same
// within T. Over times much longer than T the place itself walks at random, with the
// density ∫ σ² exp(−|t|/T) dt = 2 σ² T.
//
// Source: R. A. Singer: Estimating optimal tracking filter performance for manned
// maneuvering targets, IEEE Trans. Aerospace and Electronic Systems 6(4), 473–483,
// 1970.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>

#include "delos/api.h"

namespace delos {

/// "Walks at 1.5 m/s, turns within 0.5 s."
struct MotionWords {
  double fast = 0;    ///< speed, m/s, or of order 3 acceleration, m/s²; > 0
  double within = 0;  ///< T, seconds, > 0
  /// Root mean square along z, in the unit of `fast`, > 0, which is then horizontal.
  /// Not given: all directions in space are alike.
  std::optional<double> vertical = std::nullopt;
};

/// q of x, y and z: (m²/s, m²/s³, m²/s⁵)
///
///     position                          2 σ² T
///     velocity, acceleration            2 σ²/T
///
/// with σ² = fast²/2 along x and y, and vertical² along z; or fast²/3 along each.
/// @pre order is 1, 2 or 3
[[nodiscard]] DELOS_API Eigen::Vector3d q_of(const MotionWords& words, int order);

/// A motion to begin with.
struct NamedMotion {
  const char* name;
  const char* what;    ///< a phrase
  int order;           ///< of the chain: 1, 2 or 3
  Eigen::Vector3d q;   ///< of x, y and z, z up; SI
  const char* source;  ///< where the numbers are from
  bool assumed;        ///< whether some of them are guessed
};

/// All of them.
[[nodiscard]] DELOS_API std::span<const NamedMotion> named_motions();

/// @returns null where there is none of that name
[[nodiscard]] DELOS_API const NamedMotion* named_motion(const std::string& name);

}  // namespace delos
