// What somebody who hangs up the devices of a scene needs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "delos/rig/system.h"
#include "session/json.h"

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

/// A wall, and how far from it something is, metres; below zero: beyond it.
struct FromWall {
  std::string wall;  ///< "left", "right", "front", "back", "floor"
  double distance = 0;
};
/// From the nearer wall across x, left or right, from the nearer one across y, front or
/// back, and from the floor.
[[nodiscard]] std::vector<FromWall> from_walls(const Eigen::Vector3d& p,
                                               const Eigen::AlignedBox3d& walls);

/// The walls that distances are from: the box around the scene's rooms, metres;
/// nullopt: it has none.
[[nodiscard]] std::optional<Eigen::AlignedBox3d> walls_of(const Scene& scene);

/// A device that stands in the world.
struct InstalledDevice {
  std::string name;
  Eigen::Vector3d at;
  std::vector<FromWall> from;  ///< empty where there are no walls
  /// The point of its axis nearest to the middle of the samples, or to where the scene
  /// says that it looks; nullopt: it looks all around, and has no facing.
  std::optional<Eigen::Vector3d> aim;
  Facing facing;
  /// The edge of its view half of the way to the samples; may be empty.
  std::vector<Eigen::Vector3d> view;
};

struct Installation {
  std::optional<Eigen::AlignedBox3d> walls;
  Eigen::AlignedBox3d samples;
  std::vector<InstalledDevice> devices;
};
[[nodiscard]] Installation installation_of(const Scene& scene, const System& system);

/// {walls: {min, max} or null, samples: {min, max}, devices: [{name, at, from: [{wall,
/// distance}], aim, pan, tilt, roll, view: [[x, y, z]]}]}; aim and angles are null
/// where it looks all around. Metres and radians.
[[nodiscard]] session::Json installation_json(const Installation& installation);

}  // namespace delos::report
