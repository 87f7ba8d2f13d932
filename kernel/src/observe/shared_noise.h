// Noise that all points seen in one update have in common.
#pragma once

#include <cstddef>
#include <vector>

#include "delos/rig/system.h"
#include "observe/state_row.h"

namespace delos {

/// Whether Device::shared_variance() is anything.
[[nodiscard]] inline bool shares_noise(const PlacedDevice& placed) {
  return !placed.device->shared_variance().isZero(0);
}

/// Make rows whose noise has a part in common rows of independent noise that know the
/// same together.
/// @param stride rows of a point; those of equal rank share their noise
/// @throws DeviceFault more is shared than there is
void part_shared_noise(const PlacedDevice& placed, std::size_t stride,
                       std::vector<StateRow>& rows);

}  // namespace delos
