// A device that stands for a guess of the pose, so that blind samples have a cost.
#pragma once

#include <memory>

#include "delos/rig/system.h"
#include "delos/sampling/samples.h"

namespace delos {

/// Whether a guess can report with the others: not where devices take turns, nor in a
/// sum of Ψ matrices.
[[nodiscard]] bool takes_guess(const System& system);

/// The guess of an objective that doesn't say: 100 √(1/λ), λ the median, over devices
/// and the samples that they see, of the greatest eigenvalue of a device's information
/// of one update about the position (of an orientation-only state, the orientation).
/// 1 where nothing is seen.
[[nodiscard]] double typical_guess(const System& system, const Samples& samples,
                                   const Orientations& orientations);

/// Information of one update of a guess, or its rate: what SoftField adds.
[[nodiscard]] double guess_information(const System& system, double sigma);

/// Add a device that measures every coordinate of the pose with this standard
/// deviation, metres and radians, wherever the target is.
void add_guess(System& system, double sigma);

}  // namespace delos
