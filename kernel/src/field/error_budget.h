// Scatter, bias and their total at one pose.
#pragma once

#include <vector>

#include "delos/field/point.h"
#include "layers/block.h"

namespace delos {

/// A pose whose scatter is solved.
struct SolvedPose {
  const TargetPose& pose;
  const LayerBlock& block;  ///< of the pose alone
  const StateMatrix& S;     ///< information_of() its equation
  const FusedState& scatter;
};

/// Fill in what errors of calibration do: the budget, each device's part of it, and the
/// state and the metrics as System::error says.
/// @pre bias_problem() of the system with any part of the error is empty
void add_budget(const System& system, const SolvedPose& at, const Metric& metric,
                PointReport& report);

}  // namespace delos
