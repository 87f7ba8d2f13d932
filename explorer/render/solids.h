// Meshes that pictures of rooms are made of.
#pragma once

#include <utility>
#include <vector>

#include "delos/geometry/mesh.h"

namespace delos::render {

/// A housing behind the origin, and a lens that opens along z. @param size metres
[[nodiscard]] TriangleMesh camera_icon(double size);

/// Ends of the edges at which a mesh bends by more than 30°, or ends.
[[nodiscard]] std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> sharp_edges(
    const TriangleMesh& mesh);

/// Of an outline, in order around z, its corners: where it is farthest from the axis;
/// of a round one, six of its points.
[[nodiscard]] std::vector<Eigen::Vector3d> corners_of(
    const std::vector<Eigen::Vector3d>& outline);

}  // namespace delos::render
