#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

#include "delos/geometry/surface.h"

namespace delos {

RailPoint rail_point(const std::vector<Eigen::Vector3d>& polyline, double s) {
  double length = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    length += (polyline[i] - polyline[i - 1]).norm();
  }
  if (!(length > 0)) throw std::invalid_argument("a rail needs a length");

  double left = std::clamp(s, 0.0, 1.0) * length;
  RailPoint at{polyline.front(), Eigen::Vector3d::Zero()};
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Eigen::Vector3d step = polyline[i] - polyline[i - 1];
    const double reach = step.norm();
    if (reach == 0) continue;
    at.tangent = step / reach;
    at.p = polyline[i - 1] + std::min(left, reach) * at.tangent;
    if (left < reach) return at;
    left -= reach;
  }
  at.p = polyline.back();
  return at;
}

SurfacePoint patch_point(const Patch& patch, double a, double b) {
  return {patch.origin + std::clamp(a, 0.0, 1.0) * patch.u +
              std::clamp(b, 0.0, 1.0) * patch.v,
          patch.u.cross(patch.v).normalized()};
}

}  // namespace delos
