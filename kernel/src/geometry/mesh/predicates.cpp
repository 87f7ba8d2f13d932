#include "geometry/mesh/predicates.h"

#include "geometry/mesh/kernel.h"

namespace delos {

int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  return CGAL::orientation(cgal_point(a), cgal_point(b), cgal_point(c), cgal_point(d));
}

bool collinear(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
               const Eigen::Vector3d& c) {
  return CGAL::collinear(cgal_point(a), cgal_point(b), cgal_point(c));
}

}  // namespace delos
