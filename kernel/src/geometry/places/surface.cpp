#include "delos/geometry/surface.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "geometry/mesh/kernel.h"

namespace delos {
namespace {

using Triangles = std::vector<Kernel::Triangle_3>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<
    Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

Eigen::Vector3d eigen_vector(const Kernel::Vector_3& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace

struct MountingSurface::Tree {
  Triangles triangles;
  AabbTree aabb;
};

MountingSurface::MountingSurface(const TriangleMesh& mesh) {
  const auto tree = std::make_shared<Tree>();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Kernel::Triangle_3 triangle(cgal_point(mesh.vertices[a]),
                                      cgal_point(mesh.vertices[b]),
                                      cgal_point(mesh.vertices[c]));
    if (!CGAL::collinear(triangle[0], triangle[1], triangle[2])) {
      tree->triangles.push_back(triangle);
    }
  }
  if (tree->triangles.empty()) {
    throw std::invalid_argument("a mounting surface needs a triangle with area");
  }
  tree->aabb.insert(tree->triangles.cbegin(), tree->triangles.cend());
  // CGAL would do both on the first query, behind a lock.
  tree->aabb.build();
  tree->aabb.accelerate_distance_queries();
  tree_ = tree;
}

SurfacePoint MountingSurface::closest(const Eigen::Vector3d& p) const {
  const auto [q, triangle] = tree_->aabb.closest_point_and_primitive(cgal_point(p));
  const Eigen::Vector3d u = eigen_vector((*triangle)[1] - (*triangle)[0]);
  const Eigen::Vector3d v = eigen_vector((*triangle)[2] - (*triangle)[0]);
  return {{q.x(), q.y(), q.z()}, u.cross(v).normalized()};
}

}  // namespace delos
