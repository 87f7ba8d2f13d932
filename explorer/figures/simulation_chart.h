// The error of simulated filters as a picture.
#pragma once

#include <string>

#include "delos/simulation/simulate.h"

namespace delos::figures {

/// Standard deviations of the position over time, a drawing in SVG: measured, the
/// filter's own, and P∞'s three; or, along a path, the mean error of one axis between
/// tubes of ±3σ.
[[nodiscard]] std::string simulation_chart(const Simulation& simulation,
                                           const StateLayout& layout);

}  // namespace delos::figures
