// What somebody who hangs up the devices of a scene needs.
#pragma once

#include <optional>
#include <string>

#include "delos/rig/system.h"
#include "report/html.h"

namespace delos::report {

/// How a device looks, radians: along its z axis, with y down.
struct Facing {
  double pan = 0;   ///< of where it looks, from x towards y, in (−π, π]
  double tilt = 0;  ///< above the horizon; negative: it looks down
  /// About where it looks, clockwise as seen from behind it; 0: its x axis is level.
  /// Where it looks straight up or down, the pan is that of its image's upper edge, and
  /// there is no roll.
  double roll = 0;
};
/// @param R_WS device to world
[[nodiscard]] Facing facing_of(const Eigen::Matrix3d& R_WS);

/// The walls that distances are from: the box around the scene's rooms, metres;
/// nullopt: it has none.
[[nodiscard]] std::optional<Eigen::AlignedBox3d> walls_of(const Scene& scene);

/// A table of all devices that stand in the world, with place, aim, pan, tilt and roll,
/// and a drawing. The aim is the point of a device's axis nearest to the middle of the
/// samples, or to where the scene says that it looks.
[[nodiscard]] Html installers_sheet(const Scene& scene, const System& system);

}  // namespace delos::report
