// A filter on readings that were recorded.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/simulation/filter.h"

namespace delos {

/// A reading and when it was taken.
struct TimedReading {
  double t = 0;  ///< seconds
  TrackReading reading;
};

/// What is known before the first reading: the state about which a track is, and how
/// well.
struct TrackStart {
  TargetPose pose;
  double position = 1;  ///< standard deviation of a coordinate, m or rad
  double rate = 1;      ///< of its derivatives, m/s, m/s², …
};

/// The filter after the readings of one instant.
struct TrackedInstant {
  double t = 0;
  double gap = 0;         ///< seconds since the instant before
  Eigen::Vector3d p;      ///< in W, metres
  Eigen::Matrix3d R;      ///< R_WT
  StateVector x;          ///< n×1, about the start
  StateMatrix P;          ///< n×n
  Innovation innovation;  ///< of these readings
};

/// Filter recorded readings: those of one time stamp are one update, and the motion
/// goes on by the times between them, whatever the rates in the scene are.
/// @param readings in the order of their times
/// @throws std::invalid_argument the motion isn't known over any time; time stamps fall
/// @throws DeviceFault
[[nodiscard]] DELOS_API std::vector<TrackedInstant> track_readings(
    const System& system, const TrackStart& start,
    const std::vector<TimedReading>& readings, const TrackFilter& filter);

}  // namespace delos
