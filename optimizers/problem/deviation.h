// Devices that aren't quite where, or what, they should be.
#pragma once

#include <Eigen/Core>
#include <string>

#include "delos/rig/system.h"
#include "delos/scene/robustness.h"

namespace delos {

/// How far one device is off in one draw.
struct Deviation {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< along the world's axes, metres
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();   ///< about its own axes, radians
  double noise = 0;  ///< of the logarithm of its noise's standard deviation
};

/// Independent normal numbers, decided by the seed, the draw and the device's name
/// alone. Draws 2k and 2k + 1 are opposite, so that a mean over pairs isn't moved by
/// what is linear in a deviation.
[[nodiscard]] Deviation deviation(const Robustness& robust, int draw,
                                  const std::string& device);

/// The device as it is then: p + place, R exp([turn]×), and noise whose covariance is
/// exp(2 noise) as large. A device on the target is moved in the target's frame.
[[nodiscard]] PlacedDevice deviated(PlacedDevice device, const Deviation& by);

}  // namespace delos
