// Units of the state in which a Riccati equation is well scaled.
#pragma once

#include <span>

#include "delos/riccati/riccati.h"

namespace delos::riccati {

/// D, powers of two, such that x = D y has noise and information of like size in every
/// y.
///
/// noise_i: variance that the process brings into state i within a few steps;
/// information_i likewise for measurements. D_i² = √(noise_i/information_i), which for
/// an integrator chain makes position, velocity and acceleration differ by powers of
/// dt. A state that has only one of the two takes the others' mean product of both.
/// Scaling by powers of two is exact, so that it never changes a structural zero or a
/// structural one.
StateVector balance(const StateVector& noise, const StateVector& information);

/// balance() of a cycle of updates, from its first few steps.
StateVector balance(std::span<const CycleStep> cycle);

/// The step in units of y: D⁻¹ A D, D⁻¹ Q D⁻¹, D S D, C D.
CycleStep scaled(const CycleStep& step, const StateVector& D);

}  // namespace delos::riccati
