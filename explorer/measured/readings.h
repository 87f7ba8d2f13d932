// Readings of a scene's devices that were recorded, and where the target was.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "delos/document/diagnostic.h"
#include "delos/rig/system.h"
#include "delos/simulation/simulate.h"
#include "delos/simulation/track_readings.h"

namespace delos::measured {

/// What a file of readings has.
struct Readings {
  std::vector<TimedReading> all;       ///< by their times
  std::vector<Eigen::Vector3d> truth;  ///< of each, or empty
  std::vector<std::size_t>
      without_truth;  ///< readings whose cells are empty: NaN above
};

/// Read a CSV with a head: `t [s]`, `device` and `z`, or `z1`, `z2`, …, in SI units of
/// the device's reading; where the target was then, in metres, in `x`, `y` and `z` — so
/// that a reading's own column is `z1` where truth is given:
///
///     t [s],device,z1,x,y,z
///
/// Readings are of the target's first marker. Findings are appended, all of a file up
/// to twenty.
/// @returns nullopt where one of them is an error: a device that the scene doesn't have
///          or that reads on the target of beacons, times that fall, no numbers
[[nodiscard]] std::optional<Readings> read_readings(const std::filesystem::path& file,
                                                    const System& system,
                                                    Diagnostics& findings);

/// Whether a file's head names a column `device`: of readings, not of places.
[[nodiscard]] bool has_readings(const std::filesystem::path& file);

}  // namespace delos::measured
