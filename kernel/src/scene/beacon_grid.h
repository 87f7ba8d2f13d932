// Which beacons of a grid are lit, and of which panel each is.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "delos/scene/scene.h"

namespace delos {

/// A lit beacon of a grid.
struct LitBeacon {
  Eigen::Vector3d p;                        ///< metres
  Eigen::Matrix<std::int64_t, 2, 1> panel;  ///< column and row of its panel
};

/// In the order of the grid, x fastest.
[[nodiscard]] std::vector<LitBeacon> lit_beacons(const BeaconGrid& grid);

}  // namespace delos
