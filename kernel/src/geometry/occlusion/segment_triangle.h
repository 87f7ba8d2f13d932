// Whether a segment meets a triangle.
#pragma once

#include <Eigen/Core>
#include <array>

#include "geometry/occlusion/segment.h"

namespace delos {

/// A triangle's.
using Corners = std::array<Eigen::Vector3d, 3>;

/// Whether s meets the triangle, as without rounding; touching is meeting.
/// @pre the triangle has an area
bool meets(const Corners& triangle, const Segment& s);

}  // namespace delos
