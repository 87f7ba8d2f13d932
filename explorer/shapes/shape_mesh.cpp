#include "shapes/shape_mesh.h"

namespace delos::shapes {
namespace {

/// Along the normal, twice as long as the area.
Eigen::Vector3d twice_area(const TriangleMesh& mesh,
                           const std::array<std::uint32_t, 3>& t) {
  const auto& v = mesh.vertices;
  return (v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]);
}

}  // namespace

double area_of(const TriangleMesh& mesh) {
  double twice = 0;
  for (const auto& t : mesh.triangles) twice += twice_area(mesh, t).norm();
  return twice / 2;
}

double volume_of(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const Eigen::Vector3d from = mesh.vertices[mesh.triangles[0][0]];  // less rounding
  double six = 0;
  for (const auto& t : mesh.triangles)
    six += (mesh.vertices[t[0]] - from).dot(twice_area(mesh, t));
  return six / 6;
}

void set_normals(ShapeMesh& shape) {
  shape.normals.assign(shape.mesh.vertices.size(), Eigen::Vector3d::Zero());
  for (std::size_t k = 0; k < shape.caps; ++k) {
    const auto& t = shape.mesh.triangles[k];
    const Eigen::Vector3d n = twice_area(shape.mesh, t);
    for (const std::uint32_t corner : t) shape.normals[corner] += n;
  }
  for (Eigen::Vector3d& n : shape.normals) n.normalize();
}

}  // namespace delos::shapes
