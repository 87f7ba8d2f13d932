// A scene: everything that a user wrote, as plain data in SI units.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "delos/device/parameters.h"
#include "delos/geometry/body.h"
#include "delos/model/covariance_kind.h"
#include "delos/model/exposure_model.h"
#include "delos/model/motion.h"
#include "delos/model/pose.h"
#include "delos/sampling/grid.h"
#include "delos/sampling/sets.h"
#include "delos/scene/calibration.h"
#include "delos/scene/sample_time.h"
#include "delos/scene/search.h"
#include "delos/scene/selection.h"
#include "delos/scene/without_sight.h"

namespace delos {

struct Beacon;

/// How the measurements of several devices come together.
enum class Fusion {
  stacked,     ///< all devices report together at every update; needs one rate
  continuous,  ///< asynchronous devices in the limit of frequent updates
  periodic,    ///< exact, over the cycle in which all rates repeat
  sequential,  ///< one device per update, round robin
  artemis,     ///< the papers' sum of Ψ matrices, for comparison with published plots
};

/// An orientation as the user gave it, so that a moved device keeps its aim.
struct Rpy {
  Eigen::Vector3d angles;  ///< roll, pitch, yaw, radians
  friend bool operator==(const Rpy&, const Rpy&) = default;
};
struct QuaternionWxyz {
  Eigen::Vector4d wxyz;  ///< normalised when placed
  friend bool operator==(const QuaternionWxyz&, const QuaternionWxyz&) = default;
};
struct Aim {
  Eigen::Vector3d
      at;           ///< the point looked at, metres, in the same frame as the position
  double roll = 0;  ///< then a turn about the z axis, from x towards y, radians
  friend bool operator==(const Aim&, const Aim&) = default;
};

/// Where something is, in its group's frame or the world's.
struct Placement {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< metres
  std::variant<std::monostate, Rpy, QuaternionWxyz, Aim>
      facing;  ///< monostate: identity
  friend bool operator==(const Placement&, const Placement&) = default;
};

/// A frame that devices are placed in.
struct Group {
  std::string name;
  Placement placement;
  friend bool operator==(const Group&, const Group&) = default;
};

/// What something is fixed to.
enum class Mount {
  world,
  target,  ///< it moves with the target; its placement is in the target's frame
};

/// Something that hides.
struct OccluderEntry {
  std::string name;  ///< may be empty
  Body body;
  bool room = false;  ///< its inside is free; its surface hides
  Mount mount = Mount::world;
  Placement placement;
  friend bool operator==(const OccluderEntry&, const OccluderEntry&) = default;
};

enum class ClutterShape { box, sphere };

/// Bodies drawn at random in the world; see drawn_bodies().
struct ClutterEntry {
  std::string name;
  int count = 0;  ///< ≥ 0
  int seed = 0;   ///< ≥ 0
  ClutterShape shape = ClutterShape::box;
  double least = 0, greatest = 0;  ///< edges or diameters, metres, > 0
  BoxShape box;                    ///< of the centres
  friend bool operator==(const ClutterEntry&, const ClutterEntry&) = default;
};

/// A named body in the world: where a search may put things, or may not.
struct RegionEntry {
  std::string name;
  Body body;
  Placement placement;
  friend bool operator==(const RegionEntry&, const RegionEntry&) = default;
};

/// Surfaces that devices are mounted on, in the world, metres. Coordinates run from 0
/// to 1.
struct PatchSurface {  ///< origin + a·u + b·v, facing along u × v
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d u = Eigen::Vector3d::UnitX(), v = Eigen::Vector3d::UnitY();
  friend bool operator==(const PatchSurface&, const PatchSurface&) = default;
};
struct RailSurface {  ///< a line through points; one coordinate, the part of its length
  std::vector<Eigen::Vector3d> points;  ///< two or more, not all the same
  friend bool operator==(const RailSurface&, const RailSurface&) = default;
};
struct MeshSurface {  ///< where the ray from a point of `from` along u × v first hits
  MeshShape mesh;
  PatchSurface from;
  friend bool operator==(const MeshSurface&, const MeshSurface&) = default;
};
struct SurfaceEntry {
  std::string name;
  std::variant<PatchSurface, RailSurface, MeshSurface> shape;
  friend bool operator==(const SurfaceEntry&, const SurfaceEntry&) = default;
};

/// A point of a surface.
struct MountPoint {
  Eigen::Vector3d p;  ///< world, metres
  /// Unit vector away from the surface; of a mesh, to the side that it was hit from.
  /// Rails have none.
  std::optional<Eigen::Vector3d> normal;
};

/// Which beacons of a grid are lit. Rows, columns and squares are of panels.
enum class BeaconPattern {
  full,          ///< all
  half,          ///< every other row, counted along y, is off
  columns,       ///< every other column, counted along x, is off
  checkerboard,  ///< every other panel is off, in rows and columns
};

/// Beacons on a regular grid, those of `pattern` lit.
struct BeaconGrid {
  VolumeSampling box;
  Eigen::Vector2i panel = {1, 1};  ///< beacons of a panel along x and y, ≥ 1
  BeaconPattern pattern = BeaconPattern::full;
  friend bool operator==(const BeaconGrid&, const BeaconGrid&) = default;
};

/// One beacon of a list.
struct BeaconEntry {
  Eigen::Vector3d p;                      ///< metres
  std::optional<Eigen::Vector3d> normal;  ///< instead of the set's, of any length but 0
  double weight = 1;                      ///< times the set's
  friend bool operator==(const BeaconEntry&, const BeaconEntry&) = default;
};

/// Beacons one by one; `file` is what they were read from, empty when inline.
struct BeaconList {
  std::string file;  ///< as written, relative to the scene's folder
  std::vector<BeaconEntry> entries;
  friend bool operator==(const BeaconList&, const BeaconList&) = default;
};

/// A named set of beacons in the world, which devices on the target look at.
struct BeaconSet {
  std::string name;
  std::variant<BeaconGrid, BeaconList> layout;
  /// Which way they face, of any length but 0; nullopt: they radiate all around.
  std::optional<Eigen::Vector3d> normal;
  double emission = std::numbers::pi / 2;  ///< half-angle about the normal, radians
  double range = std::numeric_limits<double>::infinity();  ///< farthest seen, metres
  double weight = 1;  ///< of each: the part of the time that it can be used, 0 to 1
  friend bool operator==(const BeaconSet&, const BeaconSet&) = default;
};

/// A marker of a body.
struct MarkerEntry {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< metres, in the body's frame
  /// Which way it faces, in the body's frame, of any length but 0; nullopt: all ways.
  std::optional<Eigen::Vector3d> normal;
  std::optional<double> half_angle;  ///< instead of the body's, radians
  friend bool operator==(const MarkerEntry&, const MarkerEntry&) = default;
};

/// Markers on the target that are fixed to each other, each seen from a cone.
struct MarkerBody {
  std::string name;
  Placement placement;                       ///< in the target's frame
  double half_angle = std::numbers::pi / 2;  ///< about each normal, radians
  std::vector<MarkerEntry> markers;
  friend bool operator==(const MarkerBody&, const MarkerBody&) = default;
};

/// Which of the beacons in view a device on the target uses in one update. A sighting
/// is one beacon through one view; its weight is the beacon's.
enum class SightingRule {
  all,      ///< every one
  mean,     ///< `count` of them, drawn with repetition: the expected information
  random,   ///< `count` different ones, or all where there are fewer: likewise
  nearest,  ///< the `count` nearest
  best,     ///< the split of `count` among them with the largest information volume
};

/// Where a device is mounted.
struct Mounting {
  std::string surface;              ///< the surface's name
  std::vector<double> coordinates;  ///< in [0, 1]: one on a rail, else two
  friend bool operator==(const Mounting&, const Mounting&) = default;
};

/// A device of the scene. Every parameter of its table has a value.
struct DeviceEntry {
  std::string name;
  std::string preset;  ///< device_preset() that fills in its parameters; may be empty
  std::string type;
  double rate = 0;  ///< updates a second, > 0; where `timing` is given, see rate_of()
  double phase =
      0;  ///< delay of the first update, seconds, ≥ 0; periodic fusion reads it
  /// A reading is the mean over so many seconds up to its update; at most 1/rate.
  double exposure = 0;
  std::optional<Timing> timing;  ///< instead of a rate, which follows the exposure
  std::optional<NoiseOverTime> noise_over_time;  ///< not given: constant
  /// Of `target`: its placement is in the target's frame, and it sees beacons.
  Mount mount = Mount::world;
  std::vector<std::string> beacons;         ///< sets that it sees; empty: all
  SightingRule select = SightingRule::all;  ///< where mount is target
  int count = 1;      ///< sightings an update, ≥ 1; see `select`
  std::string clock;  ///< devices of one clock share an unknown offset; empty: none
  std::string group;  ///< empty: the world
  /// Given: it stands there, and not at placement.at; group is empty.
  std::optional<Mounting> mounting;
  Placement placement;
  ParamValues params;
  Calibration calibration;     ///< how well it is known
  WithoutSight without_sight;  ///< of a device in the world that sees points
  friend bool operator==(const DeviceEntry&, const DeviceEntry&) = default;
};

/// How the offset of a clock changes, in a filter: a first-order Gauss–Markov process.
/// A clock without an entry is unknown anew at each update.
struct ClockEntry {
  std::string name;
  double time_constant = std::numeric_limits<double>::infinity();  ///< seconds, > 0
  double density =
      0;  ///< of the noise that drives it, squared readings per second, ≥ 0
  friend bool operator==(const ClockEntry&, const ClockEntry&) = default;
};

/// A motion that the target may have instead of the scene's.
struct MotionEntry {
  std::string name;
  MotionModel motion;
  friend bool operator==(const MotionEntry&, const MotionEntry&) = default;
};

/// A metric by a formula.
struct MetricEntry {
  std::string name;
  std::string expression;
  bool larger_is_better = false;
  std::string unit;  ///< where the formula leaves it open; else empty
  friend bool operator==(const MetricEntry&, const MetricEntry&) = default;
};

/// A whole scene.
struct DELOS_API Scene {
  std::string name;
  MotionModel motion;
  std::vector<MotionEntry> motions;  ///< others, each evaluated by itself when asked
  std::optional<Fusion> fusion;      ///< not given: see definition_of()
  std::vector<SampleSet> samples;
  Orientations orientations;
  CovarianceKind covariance = CovarianceKind::prior;
  double lag = 0;  ///< seconds from what `covariance` says to when it is used, ≥ 0
  ErrorPart error = ErrorPart::total;  ///< where devices say how well they are known
  ExposureModel exposures = ExposureModel::exact;
  std::vector<MetricEntry> metrics;  ///< its own; each may read those before it
  std::string metric = "eigmax";
  /// Points on the target that point devices observe, metres, in the target's frame.
  std::vector<Eigen::Vector3d> markers = {Eigen::Vector3d::Zero()};
  std::vector<MarkerBody> bodies;  ///< whose markers are observed, too
  /// How fast the target usually is, in any direction: root mean square, m/s. Only what
  /// readings that are older than taken for do depends on it.
  double speed = 0;
  std::vector<Group> groups;
  std::vector<SurfaceEntry> surfaces;
  std::vector<RegionEntry> regions;
  std::vector<BeaconSet> beacons;
  std::vector<ClockEntry> clocks;
  std::vector<DeviceEntry> devices;
  std::vector<CommonError> common_errors;
  std::vector<OccluderEntry> occluders;
  std::vector<ClutterEntry> clutter;
  /// How near to the ends of a sight line nothing hides, metres: a sensor on a wall, a
  /// marker on a body.
  double skin = 1e-3;
  std::vector<VariableEntry> variables;
  std::vector<ConstraintEntry> constraints;
  Objective objective;
  Selection selection;

  // Member by member, as usual, but compiled once and not wherever a scene is copied.
  Scene();
  Scene(const Scene&);
  Scene(Scene&&) noexcept;
  Scene& operator=(const Scene&);
  Scene& operator=(Scene&&) noexcept;
  ~Scene();
  bool operator==(const Scene&) const;
};

/// The words that scenes, JSON and messages use.
[[nodiscard]] DELOS_API const char* to_string(Fusion fusion);
[[nodiscard]] DELOS_API const char* to_string(CovarianceKind kind);
[[nodiscard]] DELOS_API const char* to_string(ErrorPart part);

/// The pose of a placement in the frame that it is given in: X_GS, X_WG, or that of an
/// occluder in the world or in the target.
[[nodiscard]] DELOS_API Pose pose_of(const Placement& placement);

/// The beacons of a set that are lit, in the order of the grid, x fastest, or the list.
[[nodiscard]] DELOS_API std::vector<Beacon> lit_beacons(const BeaconSet& set);

/// The point of a surface at these coordinates.
/// @returns nullopt where the ray of a mesh surface hits nothing
/// @pre as many coordinates as the surface has
/// @cost linear in the mesh's triangles
[[nodiscard]] DELOS_API std::optional<MountPoint> mount_point(
    const SurfaceEntry& surface, const std::vector<double>& coordinates);

/// X_WS of a device in the world: its placement within its group, or its place on its
/// surface, where its z axis is the surface's normal unless its placement says where it
/// faces.
/// @pre the group or the surface exists
/// @throws Unbuildable one sentence: the ray of a mesh surface hits nothing there
[[nodiscard]] DELOS_API Pose device_pose(const Scene& scene, const DeviceEntry& device);

}  // namespace delos
