// A weak guess of the pose, so that blind samples have a cost.
#pragma once

#include "delos/rig/system.h"
#include "delos/sampling/samples.h"

namespace delos {

/// The guess of an objective that doesn't say: 100 √(1/λ), λ the median, over devices
/// and the samples that they see, of the greatest eigenvalue of a device's information
/// of one update about the position (of an orientation-only state, the orientation).
/// 1 where nothing is seen.
[[nodiscard]] double typical_guess(const System& system, const Samples& samples,
                                   const Orientations& orientations);

/// The prior of a system, see there, that guesses every coordinate of the pose with
/// this standard deviation, metres and radians; under continuous fusion, as often as
/// the first device reports. 0 where devices take turns, and in a sum of Ψ matrices.
[[nodiscard]] double guess_information(const System& system, double sigma);

}  // namespace delos
