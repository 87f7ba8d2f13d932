// P∞ at the places of a comparison.
#pragma once

#include <vector>

#include "delos/rig/system.h"

namespace delos::measured {

/// σ of x, y and z at places, metres: +∞ where P∞ isn't finite, NaN of an axis that the
/// state doesn't have.
/// @param rpy the target's orientation, radians
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] std::vector<Eigen::Vector3d> predicted_at(
    const System& system, const std::vector<Eigen::Vector3d>& places,
    const Eigen::Vector3d& rpy);

}  // namespace delos::measured
