#include "field/surface_normals.h"

#include <Eigen/Geometry>

namespace delos {

std::vector<Eigen::Vector3d> surface_normals(const Samples& samples) {
  std::vector<Eigen::Vector3d> normals(samples.points.size(), Eigen::Vector3d::Zero());
  for (const SamplePart& part : samples.parts) {
    if (const auto* plane = std::get_if<PlaneShape>(&part.shape)) {
      const Eigen::Vector3d n = plane->u.cross(plane->v).normalized();
      for (std::size_t i = 0; i < part.count; ++i) normals[part.first + i] = n;
    } else if (const auto* mesh = std::get_if<SurfaceShape>(&part.shape)) {
      for (const auto& t : mesh->triangles) {
        const auto corner = [&](int c) -> const Eigen::Vector3d& {
          return samples.points[part.first + t[static_cast<std::size_t>(c)]];
        };
        const Eigen::Vector3d n =
            (corner(1) - corner(0)).cross(corner(2) - corner(0));  // twice the area
        for (const std::uint32_t vertex : t) normals[part.first + vertex] += n;
      }
      for (std::size_t i = 0; i < part.count; ++i) normals[part.first + i].normalize();
    }
  }
  return normals;
}

}  // namespace delos
