// The edge of what a device sees, asked of the device itself, so that a picture shows
// the frustum of any plugin.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "delos/device/device.h"

namespace delos::session {

/// Points on the edge of the view, all at z = `depth` of the device's frame, metres, in
/// the order of their angle about its z axis. Along each such direction the view is
/// taken to be one piece from the axis out.
/// @returns none where the device doesn't see along its axis, or sees more than a
///          picture could show as a cone: all around, or nearly half of that
/// @param depth where to look, metres, > 0; nearer or farther where it sees nothing
/// there
[[nodiscard]] std::vector<Eigen::Vector3d> view_outline(const Device& device,
                                                        double depth);

}  // namespace delos::session
