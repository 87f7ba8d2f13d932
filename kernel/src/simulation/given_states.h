// A given path as states of the motion.
#pragma once

#include <vector>

#include "delos/simulation/simulate.h"
#include "simulation/motion_steps.h"

namespace delos {

/// The state of a target on a path before the first instant and at each: between its
/// points cubics with the slopes of the parabolas through three neighbours (Hermite),
/// so that position and velocity are continuous.
/// @throws std::invalid_argument its times don't rise, or it has fewer than two points
[[nodiscard]] std::vector<StateVector> given_states(const System& system,
                                                    const TargetPose& about,
                                                    const GivenPath& path,
                                                    const MotionSteps& steps,
                                                    std::size_t instants);

}  // namespace delos
