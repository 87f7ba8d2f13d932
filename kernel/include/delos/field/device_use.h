// What each device sees of a scene's samples, and why it doesn't see the others.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/rig/system.h"

namespace delos {

/// What one device in the world is to places of the target. What it doesn't see is
/// told by moving along the line from the device to the place: too far where it sees
/// nearer places of that line, too near where it sees farther ones, aside where none.
struct DeviceUse {
  std::size_t places = 0;
  std::size_t sees = 0;
  std::size_t hidden = 0;  ///< it would see them if nothing stood in between
  std::size_t too_far = 0, too_near = 0, aside = 0;
  /// Of the hidden ones: something in the world is in the way within kAtOnce of it.
  std::size_t at_once = 0;
  double nearest = 0, farthest = 0;  ///< places from the device, metres
  double reach = 0;        ///< the farthest that it sees towards those too far, metres
  double least_reach = 0;  ///< the nearest that it sees towards those too near, metres
  /// How many it would see at a thousandth of their distance.
  std::size_t sees_thousandth = 0;
  static constexpr double kAtOnce = 0.05;  ///< metres
};

/// @param poses at least one
/// @pre the device stands in the world
[[nodiscard]] DELOS_API DeviceUse device_use(const System& system,
                                             const PlacedDevice& placed,
                                             const std::vector<TargetPose>& poses);

/// How many of the places a device sees, whatever hides them.
[[nodiscard]] DELOS_API std::size_t in_view(const System& system,
                                            const PlacedDevice& placed,
                                            const std::vector<TargetPose>& poses);

/// How wide a device sees about a line on which it sees something, at its widest:
/// radians, 2π for all around; NaN where it sees no place, nor along an axis of its
/// frame.
[[nodiscard]] DELOS_API double field_of_view(const System& system,
                                             const PlacedDevice& placed,
                                             const std::vector<TargetPose>& poses);

}  // namespace delos
