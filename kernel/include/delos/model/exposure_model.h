// What is taken for the motion in a reading that takes time.
#pragma once

#include "delos/api.h"

namespace delos {

/// How the motion during an exposure enters a reading. All but `exact` are what the
/// paper on sample times prints: a variance that is added to R of a reading of the
/// instant at which the window ends, as if it had nothing to do with the motion between
/// updates. Source: Welch, Allen, Ilie, Bishop (2007).
enum class ExposureModel {
  exact,          ///< the mean of the pose over the window, and what it shares with w
  instantaneous,  ///< how far the end may be from the begin, Q_00(τ); Eqs. 4–6
  averaged,       ///< half of that displacement, Q_00(τ)/4; Eq. 8
  integrated,     ///< the integral's, not divided by τ, m² s²; Eq. 9
};

/// The variance that the motion during an exposure adds to a reading of one coordinate
/// of order k driven by unit white noise:
///
///     exact           τ^(2k−1) / ((2k+1) (k!)²)       of the mean, the state at the
///                                                     window's end being known
///     instantaneous   τ^(2k−1) / ((2k−1) ((k−1)!)²)
///     averaged        a quarter of the latter
///     integrated      τ² times the first
///
/// @param order k, 1 to 3
/// @param exposure τ, seconds, ≥ 0
[[nodiscard]] DELOS_API double motion_variance(ExposureModel model, int order,
                                               double exposure);

}  // namespace delos
