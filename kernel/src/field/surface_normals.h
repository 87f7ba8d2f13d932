// Which way the surface of samples faces.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "delos/sampling/samples.h"

namespace delos {

/// A unit normal for each sample of a plane or a mesh, of a vertex the mean of its
/// triangles' by their areas, in W; zero for all others. Its sign says nothing.
[[nodiscard]] std::vector<Eigen::Vector3d> surface_normals(const Samples& samples);

}  // namespace delos
