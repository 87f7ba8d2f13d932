// What a simulation is held against: P∞, instant by instant, and what is looked at.
#pragma once

#include <string>
#include <vector>

#include "delos/riccati/riccati.h"
#include "delos/rig/schedule.h"
#include "delos/rig/system.h"
#include "delos/steady/fused_state.h"

namespace delos {

/// A covariance as a mean over instants of the last cycle, before and after their
/// updates.
struct CovarianceLook {
  std::string name;
  StateMatrix predicted;                 ///< n×n
  std::vector<double> prior, posterior;  ///< weights, one a slot
};

/// What is expected of a system at one pose.
struct Expectation {
  std::vector<UpdateSlot> slots;
  std::vector<SteadyState> states;    ///< of each slot, n×n
  std::vector<CovarianceLook> looks;  ///< first that which the scene means
  /// What constant errors add to each covariance, n×n; the looks' have it, the states'
  /// don't. Zero where numbers don't count it.
  StateMatrix bias;
  double time_constant = 0;  ///< seconds
};

/// @throws std::invalid_argument the system can't be simulated, or has no P∞ there
[[nodiscard]] Expectation expectation(const System& system, const TargetPose& pose);

/// Variances of P∞, and of constant errors where numbers count them, at poses, by
/// state; +∞ where a direction that isn't observed reaches a state.
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] std::vector<StateVector> steady_variances(
    const System& system, const std::vector<TargetPose>& poses, CovarianceKind kind);

/// The cycle in which a system's devices report.
/// @throws std::invalid_argument it can't be simulated
[[nodiscard]] std::vector<UpdateSlot> simulated_slots(const System& system);

}  // namespace delos
