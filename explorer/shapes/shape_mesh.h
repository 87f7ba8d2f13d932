// A surface that is made of a field's values.
#pragma once

#include <vector>

#include "delos/geometry/mesh.h"

namespace delos::shapes {

/// Triangles, and what the field is at their corners.
struct ShapeMesh {
  TriangleMesh mesh;                     ///< world, metres; what it bounds lies inside
  std::vector<Eigen::Vector3d> normals;  ///< unit length; zero where only caps meet
  std::vector<double> values;            ///< SI
  /// From here on triangles are caps: flat, where what is bounded ends with the
  /// samples.
  std::size_t caps = 0;
};

/// The area of all triangles, m².
[[nodiscard]] double area_of(const TriangleMesh& mesh);

/// The volume that a closed mesh bounds, m³.
[[nodiscard]] double volume_of(const TriangleMesh& mesh);

/// Normals of vertices from the triangles up to `caps`, each weighed by its area.
void set_normals(ShapeMesh& shape);

}  // namespace delos::shapes
