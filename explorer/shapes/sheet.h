// Flat sheets of samples: layers of grids, and planes.
#pragma once

#include <functional>
#include <optional>

#include "delos/sampling/samples.h"

namespace delos::shapes {

/// A plane across an axis.
struct AxisPlane {
  int axis = 2;                   ///< 0, 1, 2: across x, y, z
  std::optional<double> at = {};  ///< metres; by default the middle
};

/// Samples of a parallelogram, the first direction fastest.
struct Sheet {
  Eigen::Vector3d origin, u, v;  ///< metres
  Eigen::Vector3d up;            ///< unit length, across it
  int nu = 0, nv = 0;
  std::function<std::size_t(int, int)> index;  ///< of a sample among those of the field

  /// Where a sample stands, metres.
  [[nodiscard]] Eigen::Vector3d at(int i, int j) const {
    return origin + (nu > 1 ? double(i) / (nu - 1) : 0) * u +
           (nv > 1 ? double(j) / (nv - 1) : 0) * v;
  }
};

/// The layer of a grid nearest to a plane; up is along the axis.
[[nodiscard]] Sheet layer_of(const SamplePart& part, const GridShape& grid,
                             const AxisPlane& plane);

/// A plane; up is never downwards.
[[nodiscard]] Sheet sheet_of(const SamplePart& part, const PlaneShape& plane);

}  // namespace delos::shapes
