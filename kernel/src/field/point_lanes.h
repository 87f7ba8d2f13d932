// What a device that sees points knows at kLanes poses, worked out side by side.
#pragma once

#include <cstdint>
#include <span>

#include "delos/field/system.h"

namespace delos {

/// Lanes as bits.
struct SeenLanes {
  std::uint64_t seen = 0;     ///< the device sees some of the target
  std::uint64_t perfect = 0;  ///< it has a row of no noise, which the sum leaves out
};

/// Add the information of a device at each pose to `layer`, packed as model/lanes.h says.
/// @param poses at most kLanes
/// @returns false where the device has no entry for many points; nothing is changed then
bool add_point_information(const System& system, const PlacedDevice& placed,
                           std::span<const TargetPose> poses, double* layer,
                           SeenLanes& lanes);

}  // namespace delos
