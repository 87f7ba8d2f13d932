#include "delos/geometry/mesh.h"

namespace delos {

TriangleMesh transformed(TriangleMesh mesh, const Pose& X_AB, double scale) {
  for (Eigen::Vector3d& p : mesh.vertices) p = X_AB * Eigen::Vector3d(scale * p);
  return mesh;
}

}  // namespace delos
