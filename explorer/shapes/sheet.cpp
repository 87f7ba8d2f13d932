#include "shapes/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace delos::shapes {

Sheet layer_of(const SamplePart& part, const GridShape& grid, const AxisPlane& plane) {
  const int axis = plane.axis;
  const std::int64_t count = grid.counts[axis];
  const double last =
      grid.origin[axis] + static_cast<double>(count - 1) * grid.step[axis];
  const double place = plane.at.value_or((grid.origin[axis] + last) / 2);
  const double n = count > 1 ? (place - grid.origin[axis]) / grid.step[axis] : 0;
  const auto layer = static_cast<std::size_t>(
      std::clamp<double>(std::round(n), 0, static_cast<double>(count - 1)));
  const std::array<std::size_t, 3> strides{
      1, static_cast<std::size_t>(grid.counts.x()),
      static_cast<std::size_t>(grid.counts.x() * grid.counts.y())};
  const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
  Sheet sheet{grid.origin,
              Eigen::Vector3d::Zero(),
              Eigen::Vector3d::Zero(),
              Eigen::Vector3d::Unit(axis),
              static_cast<int>(grid.counts[a]),
              static_cast<int>(grid.counts[b]),
              {}};
  sheet.origin[axis] += static_cast<double>(layer) * grid.step[axis];
  sheet.u[a] = static_cast<double>(grid.counts[a] - 1) * grid.step[a];
  sheet.v[b] = static_cast<double>(grid.counts[b] - 1) * grid.step[b];
  sheet.index = [=, first = part.first](int i, int j) {
    return first + layer * strides[static_cast<std::size_t>(axis)] +
           static_cast<std::size_t>(i) * strides[static_cast<std::size_t>(a)] +
           static_cast<std::size_t>(j) * strides[static_cast<std::size_t>(b)];
  };
  return sheet;
}

Sheet sheet_of(const SamplePart& part, const PlaneShape& plane) {
  const Eigen::Vector3d across = plane.u.cross(plane.v).normalized();
  const int nu = plane.counts.x();
  return {plane.origin,
          plane.u,
          plane.v,
          across.z() < 0 ? -across : across,
          nu,
          plane.counts.y(),
          [first = part.first, nu](int i, int j) {
            return first + static_cast<std::size_t>(i) +
                   static_cast<std::size_t>(j) * static_cast<std::size_t>(nu);
          }};
}

}  // namespace delos::shapes
