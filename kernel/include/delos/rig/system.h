// A scene made ready to be evaluated: devices created and placed.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "delos/api.h"
#include "delos/device/beacons.h"
#include "delos/geometry/occluders.h"
#include "delos/model/metric.h"
#include "delos/model/motion.h"
#include "delos/model/pose.h"
#include "delos/scene/definition.h"
#include "delos/scene/scene.h"

namespace delos {

class PluginRegistry;

/// A point on the target that point devices observe.
struct PlacedMarker {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  ///< in the target's frame T, metres
  /// Which way it faces, a unit vector in T; zero: all ways.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double half_angle = 0;  ///< about the normal, from where it is seen, radians

  PlacedMarker() = default;
  // Implicit: a marker that is seen from all around.
  // NOLINTBEGIN(google-explicit-constructor)
  template <class Place>
  PlacedMarker(const Eigen::MatrixBase<Place>& at) : p(at) {}
  // NOLINTEND(google-explicit-constructor)
  PlacedMarker(double x, double y, double z) : p(x, y, z) {}

  /// How far a point is inside the cone from where the marker is seen, metres, at least
  /// 0 inside. It changes by no more than the metres that the point moves.
  /// @param way from the marker, in T
  [[nodiscard]] double margin(const Eigen::Vector3d& way) const {
    const double along = normal.dot(way), aside = normal.cross(way).norm();
    const double sine = std::sin(half_angle), cosine = std::cos(half_angle);
    const double margin = sine * along - cosine * aside;
    // More than a right angle off its edge, the apex is the nearest of the cone.
    return cosine * along + sine * aside < 0 ? std::copysign(way.norm(), margin)
                                             : margin;
  }
  [[nodiscard]] bool faces_all_ways() const { return normal.isZero(0); }

  friend bool operator==(const PlacedMarker&, const PlacedMarker&) = default;
};

/// How a device stands that looks at the target.
struct WorldMount {
  Pose X_WS;  ///< device frame to world
  friend bool operator==(const WorldMount&, const WorldMount&) = default;
};

/// How the target carries a device: one that looks at beacons in the world, or, where
/// it doesn't see points, that measures how it moves itself.
struct TargetMount {
  Pose X_TS;                                   ///< device frame to target
  std::shared_ptr<const BeaconIndex> beacons;  ///< never null; empty of the latter
  std::vector<std::string> sees;               ///< sets of beacons; empty: all
  SightingRule select = SightingRule::all;
  int count = 1;  ///< sightings an update, see `select`
  friend bool operator==(const TargetMount&, const TargetMount&) = default;
};

/// A parameter of a device that isn't known exactly.
struct DoubtfulParameter {
  std::string name;
  double deviation = 0;  ///< standard deviation, SI, > 0
  /// The device with it a little more, and a little less: `between` lies between both.
  std::shared_ptr<const Device> above, below;
  double between = 0;
};

/// A device in its place.
struct PlacedDevice {
  std::string name;
  std::string type;
  ParamValues params;                    ///< what `device` was made from
  std::shared_ptr<const Device> device;  ///< never null
  /// Device::lenses(), in S, metres: one or more.
  std::vector<Eigen::Vector3d> lenses = {Eigen::Vector3d::Zero()};
  std::variant<WorldMount, TargetMount> mount;
  double noise = 1;   ///< its noise's covariance is so many times what it says, > 0
  double period = 0;  ///< seconds between updates, > 0
  double phase = 0;   ///< seconds to the first update, ≥ 0
  /// Seconds up to an update over which its reading is the mean, ≤ period; 0: it is of
  /// that instant.
  double exposure = 0;
  std::optional<int> clock;                 ///< the state that its readings are off by
  StateBlock own;                           ///< its own states
  Calibration calibration;                  ///< how well it is known
  std::vector<DoubtfulParameter> doubtful;  ///< calibration.params
  /// Which of System::common_errors it has a share in, rising.
  std::vector<std::size_t> common_errors;
  WithoutSight without_sight;

  /// How the target carries it; null: it stands in the world.
  [[nodiscard]] const TargetMount* carried() const {
    return std::get_if<TargetMount>(&mount);
  }
  /// Whether it looks at beacons from the target.
  [[nodiscard]] bool sees_beacons() const {
    return carried() && device->span() == Span::point;
  }
  /// Device frame to world. @pre it stands there
  [[nodiscard]] const Pose& X_WS() const { return std::get<WorldMount>(mount).X_WS; }
  [[nodiscard]] Pose& X_WS() { return std::get<WorldMount>(mount).X_WS; }
  /// Whether its sight lines all end at its origin.
  [[nodiscard]] bool looks_from_origin() const {
    return lenses.size() == 1 && lenses.front().isZero(0);
  }
};

/// Errors that several devices have in common.
struct PlacedCommonError {
  std::string name;
  Pose X_WF;  ///< along whose axes and about whose origin they are
  Calibration of;
};

/// All that the steady-state equation needs of a scene.
struct DELOS_API System {
  MotionModel motion;
  Fusion fusion = Fusion::stacked;
  CovarianceKind covariance = CovarianceKind::prior;
  double lag = 0;  ///< seconds from what `covariance` says to when it is used, ≥ 0
  ErrorPart error = ErrorPart::total;
  ExposureModel exposures =
      ExposureModel::exact;         ///< how readings that take time count
  std::vector<Metric> own_metrics;  ///< the scene's own, by formulas
  /// Information that every update adds to each coordinate of the pose besides what the
  /// devices measure, or its rate under continuous fusion; 1/m² and 1/rad², ≥ 0.
  double prior = 0;
  std::vector<PlacedMarker> markers;
  std::vector<PlacedDevice> devices;
  std::vector<PlacedCommonError> common_errors;
  double speed = 0;                      ///< of the target, root mean square, m/s
  std::vector<BeaconSet> beacon_sets;    ///< what the devices' beacons were made from
  std::vector<OccluderEntry> occluders;  ///< what the two below were made from
  Occluders in_world;                    ///< what hides, in W
  Occluders on_target;  ///< what hides and moves with the target, in its frame T
  double skin = 1e-3;   ///< nothing hides so near to the ends of a sight line, metres

  // Member by member, as usual, but compiled once and not wherever a system is copied.
  System();
  System(const System&);
  System(System&&) noexcept;
  System& operator=(const System&);
  System& operator=(System&&) noexcept;
  ~System();
};

/// Create and place the devices of a scene.
///
/// @param previous where given, its devices of equal type and parameters are reused, so
///        that moving a device creates none; likewise its occluders.
/// @pre the scene came from load_scene(), or passed its checks
/// @throws Unbuildable a device refuses its values, or its place isn't there
/// @throws std::runtime_error a plugin is missing or broken
[[nodiscard]] DELOS_API System build_system(const Scene& scene, PluginRegistry& plugins,
                                            const System* previous = nullptr);

/// One body by itself, in the frame that it is mounted in.
[[nodiscard]] DELOS_API Occluders placed_body(const OccluderEntry& entry);

/// The size of the information that the devices give: d where all measure the pose
/// alone, else n.
[[nodiscard]] DELOS_API int information_size(const System& system);

/// Whether all devices expose equally long, or none does: what they know of their mean
/// adds up.
[[nodiscard]] DELOS_API bool has_one_exposure(const System& system);

/// Whether devices have constant errors: of calibration, or of readings without sight.
[[nodiscard]] DELOS_API bool has_constant_errors(const System& system);

/// Whether numbers count what constant errors do.
[[nodiscard]] DELOS_API bool counts_bias(const System& system);

/// What a system's numbers are of.
[[nodiscard]] DELOS_API Definition definition_of(const System& system);

/// By how much of what a device measures at once the information grows in one update,
/// or, under continuous fusion, in a second: 1, or its rate.
[[nodiscard]] DELOS_API double information_weight(const System& system,
                                                  const PlacedDevice& device);

/// A target's pose in the world, X_WT.
using TargetPose = Pose;

}  // namespace delos
