// A device that stands for a guess of the pose, so that blind samples have a cost.
#pragma once

#include <memory>

#include "delos/field/system.h"

namespace delos {

/// Whether a guess can report with the others: not where devices take turns, nor in a
/// sum of Ψ matrices.
[[nodiscard]] bool takes_guess(const System& system);

/// Information of one update of a guess, or its rate: what SoftField adds.
[[nodiscard]] double guess_information(const System& system, double sigma);

/// Add a device that measures every coordinate of the pose with this standard
/// deviation, metres and radians, wherever the target is.
void add_guess(System& system, double sigma);

}  // namespace delos
