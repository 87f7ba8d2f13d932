// What the devices of a system read of a simulated target.
#pragma once

#include <vector>

#include "delos/simulation/filter.h"
#include "observe/beacon_sightings.h"
#include "simulation/drawn_errors.h"
#include "simulation/random.h"

namespace delos {

/// Memory of one thread.
struct ReadingScratch {
  PredictedReading predicted;
  BeaconSearch beacons;
  std::vector<std::uint32_t> picked;  ///< sightings, as often as they are used
};

/// Append a device's readings of a target: of the markers that it sees, or of the
/// beacons that it picks by its rule's shares. What comes without sight is there by its
/// probability.
/// @param errors null: devices stand where the model has them, and nothing is late
/// @param information where given, Σ Hᵀ R⁻¹ H at the true state is added, N×N, of its
///        lower triangle; and `perfect` is set where a row has no noise
/// @throws DeviceFault
void draw_readings(const ReadingModel& model, int device, const StateBlock& block,
                   const StateVector& x, const Eigen::Matrix3d& R, RunRandom& noise,
                   RunRandom& beacons, ReadingScratch& scratch,
                   std::vector<TrackReading>& readings, StateMatrix& information,
                   bool& perfect, DrawnErrors* errors);

}  // namespace delos
