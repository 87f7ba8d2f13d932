// The parts of a system's information that are interpolated one by one.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "delos/rig/system.h"

namespace delos {

/// What one device sees of one marker; or of the whole target, where the device has no
/// entry for many points.
///
/// The first kind interpolates whitened rows R^(−1/2) H: they are smooth wherever the
/// marker is in view, behind an obstacle too, and S = Σ hᵀh of interpolated rows is
/// never indefinite nor of higher rank than the device's. The second kind interpolates
/// S itself, where the device sees the target at all nodes.
struct Sighting {
  std::size_t device = 0;
  PlacedMarker marker;
  bool by_rows = false;
  int rows = 0;             ///< where by_rows
  int columns = 0;          ///< of a row, or of S
  std::size_t offset = 0;   ///< of its first number in a node's record
  std::size_t numbers = 0;  ///< in a node's record
};

/// All sightings of a system, and how many numbers a node's record has.
struct Sightings {
  explicit Sightings(const System& system);
  std::vector<Sighting> all;
  std::size_t record = 0;
};

}  // namespace delos
