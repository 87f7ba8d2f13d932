// Sight lines between devices and markers.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "delos/api.h"
#include "delos/rig/system.h"
#include "delos/sampling/samples.h"

namespace delos {

/// What is known of a sight line before anybody looks along it.
enum class Sight : std::uint8_t {
  unknown,  ///< cast a ray
  clear,    ///< nothing is in the way
  hidden,   ///< something is
};

/// Whether the scene has anything that may hide the target from this device: bodies, or
/// markers that may face away.
[[nodiscard]] bool may_be_hidden(const System& system, const PlacedDevice& placed);

/// Whether there may be readings that come through what stands in their way.
[[nodiscard]] inline bool reads_without_sight(const System& system,
                                              const PlacedDevice& placed) {
  return placed.without_sight.arrives() && may_be_hidden(system, placed);
}

/// Whether nothing stands between something in the world and something on the target:
/// a device and a marker, or a beacon and a device.
/// @param in_world where the one is, in W
/// @param arm where the other is from the target's origin, in W
[[nodiscard]] DELOS_API bool in_sight(const System& system,
                                      const Eigen::Vector3d& in_world,
                                      const TargetPose& X_WT,
                                      const Eigen::Vector3d& arm);

/// The same of all lenses of a device in the world and a marker, which must face them,
/// too.
[[nodiscard]] DELOS_API bool in_sight(const System& system, const PlacedDevice& placed,
                                      const TargetPose& X_WT,
                                      const PlacedMarker& marker);

/// The same for all positions of the target in a box at one orientation R_WT: clear and
/// hidden hold for every one of them, unknown where they differ or nobody can say.
[[nodiscard]] DELOS_API Sight sight_of_box(const System& system,
                                           const PlacedDevice& placed,
                                           const Eigen::Matrix3d& R_WT,
                                           const PlacedMarker& marker,
                                           const Eigen::AlignedBox3d& box);

/// Whether a point is inside a solid of the world, or on its surface.
[[nodiscard]] bool inside_solid(const System& system, const Eigen::Vector3d& p);

/// Whether it is inside and farther than the skin from every surface: what may be a
/// marker on a body isn't.
[[nodiscard]] bool deep_inside_solid(const System& system, const Eigen::Vector3d& p);

/// Whether samples are inside a solid; empty where nothing is solid. Points that
/// somebody chose, and those of a mesh, may be markers on a body: within the skin of a
/// surface they aren't inside.
[[nodiscard]] std::vector<unsigned char> inside_solids(const System& system,
                                                       const Samples& samples);

}  // namespace delos
