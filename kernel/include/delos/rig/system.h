// A scene made ready to be evaluated: devices created and placed.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/device/beacons.h"
#include "delos/geometry/occluders.h"
#include "delos/model/motion.h"
#include "delos/model/pose.h"
#include "delos/plugin/registry.h"
#include "delos/scene/scene.h"

namespace delos {

/// A device in its place.
struct PlacedDevice {
  std::string name;
  std::string type;
  ParamValues params;                    ///< what `device` was made from
  std::shared_ptr<const Device> device;  ///< never null
  Pose X_WS;                             ///< device frame to world
  /// What it looks at where the target carries it, by X_TS; null: it stands in the
  /// world, by X_WS, and looks at the target.
  std::shared_ptr<const BeaconIndex> beacons;
  Pose X_TS;                      ///< device frame to target
  std::vector<std::string> sees;  ///< sets of beacons; empty: all
  SightingRule select = SightingRule::all;
  int count = 1;      ///< sightings an update, see `select`
  double period = 0;  ///< seconds between updates, > 0
  double phase = 0;   ///< seconds to the first update, ≥ 0
};

/// All that the steady-state equation needs of a scene.
struct System {
  MotionModel motion;
  Fusion fusion = Fusion::stacked;
  CovarianceKind covariance = CovarianceKind::prior;
  std::vector<Eigen::Vector3d> markers;  ///< in the target's frame, metres
  std::vector<PlacedDevice> devices;
  std::vector<BeaconSet> beacon_sets;    ///< what the devices' beacons were made from
  std::vector<OccluderEntry> occluders;  ///< what the two below were made from
  Occluders in_world;                    ///< what hides, in W
  Occluders on_target;  ///< what hides and moves with the target, in its frame T
  double skin = 1e-3;   ///< nothing hides so near to the ends of a sight line, metres
};

/// Create and place the devices of a scene.
///
/// @param previous where given, its devices of equal type and parameters are reused, so
///        that moving a device creates none; likewise its occluders.
/// @pre the scene came from load_scene(), or passed its checks
/// @throws std::exception what a plugin's constructor throws for clashing values
/// @throws std::runtime_error a plugin is missing or broken
[[nodiscard]] DELOS_API System build_system(const Scene& scene, PluginRegistry& plugins,
                                            const System* previous = nullptr);

/// One body by itself, in the frame that it is mounted in.
[[nodiscard]] DELOS_API Occluders placed_body(const OccluderEntry& entry);

/// The size of the information that the devices give: d where all measure the pose
/// alone, else n.
[[nodiscard]] DELOS_API int information_size(const System& system);

/// A target's pose in the world, X_WT.
using TargetPose = Pose;

}  // namespace delos
