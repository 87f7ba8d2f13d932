#include "delos/geometry/region.h"

#include <stdexcept>

#include "geometry/mesh/topology.h"

namespace delos {

Region::Region(const TriangleMesh& mesh) : body_({mesh}), surface_(mesh) {
  if (!closure_of(topology_of(mesh)).closed) {
    throw std::invalid_argument("a region needs a closed mesh");
  }
}

bool Region::contains(const Eigen::Vector3d& p) const { return body_.contains(p); }

double Region::signed_distance(const Eigen::Vector3d& p) const {
  const double distance = (surface_.closest(p).p - p).norm();
  return contains(p) ? -distance : distance;
}

}  // namespace delos
