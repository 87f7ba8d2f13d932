// Answers of devices, checked where they enter: what a plugin gets wrong is refused by
// the device's name and never taken for a reading, let alone for a perfect one.
#pragma once

#include <cmath>
#include <string>

#include "delos/device/device.h"
#include "delos/rig/system.h"

namespace delos {

/// @throws DeviceFault always: "<device> (<type>): <fault>"
[[noreturn]] void blame(const PlacedDevice& placed, const std::string& fault);

/// Throw the exception that is being handled on, in the device's name.
/// @throws std::bad_alloc, DeviceFault as they are; DeviceFault for any other
[[noreturn]] void rethrow_named(const PlacedDevice& placed);

/// Call a device: `entry(device)`.
/// @throws DeviceFault where it throws; std::bad_alloc as it is
template <class Entry>
bool ask(const PlacedDevice& placed, Entry&& entry) {
  try {
    return entry(*placed.device);
  } catch (...) {
    rethrow_named(placed);
  }
}

/// What is wrong with an answer, by a device whose span has so many columns: sizes,
/// numbers that aren't finite, or an R that no covariance can be. Null: nothing.
[[nodiscard]] const char* answer_fault(const Observation& answer, Eigen::Index columns);

/// @throws DeviceFault as answer_fault() says
inline void check_answer(const PlacedDevice& placed, const Observation& answer,
                         Eigen::Index columns) {
  // What is measured most often, a row with noise, is told to be sound at a glance.
  const bool row = answer.R.size() == 1 && answer.H.rows() == 1 &&
                   answer.H.cols() == columns && std::isfinite(answer.R(0, 0)) &&
                   answer.R(0, 0) >= 0 && answer.H.allFinite();
  if (row) return;
  if (const char* fault = answer_fault(answer, columns)) blame(placed, fault);
}

/// The same of many points, whose Jacobians are looked at when all devices are summed.
/// @throws DeviceFault
inline void check_rows(const PlacedDevice& placed, const RowLanes& answer) {
  if (answer.rows < 0 || answer.rows > kMaxLaneRows)
    blame(placed, "answers for many points with " + std::to_string(answer.rows) +
                      " rows, not 0 to " + std::to_string(kMaxLaneRows));
}

/// A variance that is too small to be inverted: perfect, or nonsense.
/// @throws DeviceFault where it is below 0 or isn't a number
inline void check_perfect(const PlacedDevice& placed, double variance) {
  if (!(variance >= 0))
    blame(placed, "answers with a variance that is below 0 or isn't a number");
}

/// observe_smoothly(), checked.
/// @throws DeviceFault
bool observe_smoothly(const PlacedDevice& placed, const Eigen::Vector3d& p,
                      SmoothRows& out);

}  // namespace delos
