// Where a field is blind, and why.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/field/field.h"
#include "delos/rig/system.h"

namespace delos {

/// What one device is to the samples of a region. Each sample counts once: as seen
/// where the device sees it in any orientation.
struct RegionView {
  std::string device;
  std::size_t sees = 0;    ///< samples
  std::size_t hidden = 0;  ///< it would see them if nothing stood in between
  std::size_t beyond = 0;  ///< out of its view or its reach, or facing away
};

/// Neighbouring samples outside solids at which some direction isn't observed.
struct BlindRegion {
  std::vector<std::size_t> samples;   ///< of the field
  Eigen::AlignedBox3d box;            ///< around them, metres
  std::size_t unseen = 0;             ///< samples that no device sees
  int least_lost = 0, most_lost = 0;  ///< directions of the pose that aren't observed
  std::vector<RegionView> views;      ///< in the order of the devices
};

/// Whether each device sees each point, in any orientation: devices × points.
[[nodiscard]] DELOS_API std::vector<std::vector<bool>> seen_points(
    const System& system, const Orientations& orientations,
    const std::vector<Eigen::Vector3d>& points);

/// The regions of a field, the one of most samples first. Samples are neighbours along
/// the axes of a volume or a plane, along the edges of a mesh, and within a leaf of an
/// octree; all scattered ones of a set are.
/// @param system, orientations what the field was evaluated with
/// @cost two evaluations of the devices at each blind sample
[[nodiscard]] DELOS_API std::vector<BlindRegion> blind_regions(
    const System& system, const Orientations& orientations, const Field& field);

}  // namespace delos
