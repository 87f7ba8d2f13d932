// Regular grids of points, as scenes write them.
#pragma once

#include <Eigen/Core>

namespace delos {

/// A regular grid of points in a box, both ends included: min, min + step, … ≤ max.
struct VolumeSampling {
  Eigen::Vector3d min;   ///< metres
  Eigen::Vector3d max;   ///< metres, ≥ min
  Eigen::Vector3d step;  ///< metres, > 0
  friend bool operator==(const VolumeSampling&, const VolumeSampling&) = default;
};

}  // namespace delos
