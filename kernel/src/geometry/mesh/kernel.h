// CGAL's numbers: doubles, and predicates that are exact for them.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Core>

namespace delos {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline Kernel::Point_3 cgal_point(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

}  // namespace delos
