// What tests of single devices ask.
#pragma once

#include <numbers>
#include <optional>

#include "delos/device/device.h"

namespace delos::test {

inline constexpr double kDegree = std::numbers::pi / 180;  // rad

/// What a device observes of a point in its frame; nothing where it doesn't see it.
inline std::optional<Observation> look(const Device& device, const Eigen::Vector3d& p) {
  Observation out;
  if (!device.observe(Target{.p_ST = p, .state = {}}, out)) return {};
  return out;
}

}  // namespace delos::test
