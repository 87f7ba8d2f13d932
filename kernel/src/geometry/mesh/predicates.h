// Exact answers about points, for sources that needn't read all of CGAL.
#pragma once

#include <Eigen/Core>

namespace delos {

/// The sign of (b − a) × (c − a) · (d − a), as without rounding: +1 where d is on the
/// side from which a, b, c run counterclockwise, −1 on the other, 0 in their plane.
/// @pre all finite
int orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                const Eigen::Vector3d& c, const Eigen::Vector3d& d);

/// Whether the three lie on one line, as without rounding.
/// @pre all finite
bool collinear(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
               const Eigen::Vector3d& c);

}  // namespace delos
