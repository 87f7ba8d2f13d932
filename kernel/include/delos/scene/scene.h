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
#include "delos/geometry/mesh.h"
#include "delos/model/motion.h"
#include "delos/model/pose.h"
#include "delos/riccati/chain.h"
#include "delos/scene/grid.h"
#include "delos/scene/search.h"
#include "delos/scene/selection.h"

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

/// How several target orientations at one point become one value.
enum class OrientationRule {
  worst,        ///< the worst value
  mean,         ///< the mean of the values
  information,  ///< the value of the mean information: visibility as a probability
};

/// counts[0]×counts[1] samples on the parallelogram origin + a·u + b·v, a and b in [0,
/// 1].
struct PlaneSampling {
  Eigen::Vector3d origin, u, v;  ///< metres
  Eigen::Vector2i counts;        ///< ≥ 1 each
  friend bool operator==(const PlaneSampling&, const PlaneSampling&) = default;
};

/// Given points; `file` is the .ptl or .csv they were read from, empty when inline.
struct PointSampling {
  std::string file;                     ///< as written, relative to the scene's folder
  std::vector<Eigen::Vector3d> points;  ///< metres
  friend bool operator==(const PointSampling&, const PointSampling&) = default;
};

/// A mesh in a file. Copies share what was read, and equal names and scales are equal:
/// within one scene a file is read once.
struct MeshShape {
  std::string file;  ///< as written, relative to the scene's folder; see read_mesh()
  double scale = 1;  ///< metres per unit of the file, > 0
  /// As it is in the file, in the file's unit. Never null in a loaded scene.
  std::shared_ptr<const TriangleMesh> mesh;
  friend bool operator==(const MeshShape& a, const MeshShape& b) {
    return a.file == b.file && a.scale == b.scale;
  }
};

/// The vertices of a mesh that is placed in the world.
struct MeshSampling {
  MeshShape surface;
  friend bool operator==(const MeshSampling&, const MeshSampling&) = default;
};

/// A box sampled by an octree, only as finely as the field needs.
struct AdaptiveSampling {
  Eigen::Vector3d min;      ///< metres
  Eigen::Vector3d max;      ///< metres, > min
  double tolerance = 0.02;  ///< relative error of the metric where it is smooth, > 0
  int depth = 6;            ///< most halvings of the box, 1 to 12
  std::optional<std::int64_t> evaluations;  ///< stop at about so many, > 0
  std::optional<double> seconds;            ///< stop after about so long, > 0
  std::optional<double> near_value;  ///< refine only around this metric's value, SI
  std::optional<Eigen::AlignedBox3d> within;  ///< refine only inside, metres
  friend DELOS_API bool operator==(const AdaptiveSampling& a,
                                   const AdaptiveSampling& b);
};

/// One named set of sample points.
struct SampleSet {
  std::string name;  ///< may be empty
  std::variant<VolumeSampling, PlaneSampling, PointSampling, MeshSampling,
               AdaptiveSampling>
      shape;
  friend bool operator==(const SampleSet&, const SampleSet&) = default;
};

/// Target orientations tried at every sample point.
struct Orientations {
  std::vector<Eigen::Vector3d> rpy = {Eigen::Vector3d::Zero()};  ///< radians
  OrientationRule combine = OrientationRule::worst;
  friend bool operator==(const Orientations&, const Orientations&) = default;
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
      at;  ///< the point looked at, metres, in the same frame as the position
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

/// Bodies in their own frame, metres.
struct BoxShape {  ///< along the axes, min < max
  Eigen::Vector3d min = Eigen::Vector3d::Zero(), max = Eigen::Vector3d::Zero();
  friend bool operator==(const BoxShape&, const BoxShape&) = default;
};
struct CylinderShape {  ///< about the z axis, from z = 0 up
  double radius = 0, height = 0;
  int sides = 32;
  friend bool operator==(const CylinderShape&, const CylinderShape&) = default;
};
struct SphereShape {  ///< about the origin
  double radius = 0;
  friend bool operator==(const SphereShape&, const SphereShape&) = default;
};
struct PrismShape {  ///< a polygon in the xy plane, from z = 0 up
  std::vector<Eigen::Vector2d> polygon;
  double height = 0;
  friend bool operator==(const PrismShape&, const PrismShape&) = default;
};
using Body = std::variant<BoxShape, CylinderShape, SphereShape, PrismShape, MeshShape>;

/// What something is fixed to.
enum class Mount {
  world,
  target,  ///< it moves with the target; its placement is in the target's frame
};

/// Something that hides.
struct OccluderEntry {
  std::string name;  ///< may be empty
  Body body;
  Mount mount = Mount::world;
  Placement placement;
  friend bool operator==(const OccluderEntry&, const OccluderEntry&) = default;
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
  std::string type;
  double rate = 0;  ///< updates a second, > 0
  double phase =
      0;  ///< delay of the first update, seconds, ≥ 0; periodic fusion reads it
  /// Of `target`: its placement is in the target's frame, and it sees beacons.
  Mount mount = Mount::world;
  std::vector<std::string> beacons;         ///< sets that it sees; empty: all
  SightingRule select = SightingRule::all;  ///< where mount is target
  int count = 1;      ///< sightings an update, ≥ 1; see `select`
  std::string group;  ///< empty: the world
  /// Given: it stands there, and not at placement.at; group is empty.
  std::optional<Mounting> mounting;
  Placement placement;
  ParamValues params;
  friend bool operator==(const DeviceEntry&, const DeviceEntry&) = default;
};

/// A whole scene.
struct Scene {
  std::string name;
  MotionModel motion;
  std::optional<Fusion> fusion;  ///< not given: stacked where all rates are equal, else
                                 ///< continuous
  std::vector<SampleSet> samples;
  Orientations orientations;
  CovarianceKind covariance = CovarianceKind::prior;
  std::string metric = "eigmax";
  /// Points on the target that point devices observe, metres, in the target's frame.
  std::vector<Eigen::Vector3d> markers = {Eigen::Vector3d::Zero()};
  std::vector<Group> groups;
  std::vector<SurfaceEntry> surfaces;
  std::vector<RegionEntry> regions;
  std::vector<BeaconSet> beacons;
  std::vector<DeviceEntry> devices;
  std::vector<OccluderEntry> occluders;
  /// How near to the ends of a sight line nothing hides, metres: a sensor on a wall, a
  /// marker on a body.
  double skin = 1e-3;
  std::vector<VariableEntry> variables;
  std::vector<ConstraintEntry> constraints;
  Objective objective;
  Selection selection;

  friend bool operator==(const Scene&, const Scene&) = default;
};

/// The words that scenes, JSON and messages use.
[[nodiscard]] DELOS_API const char* to_string(Fusion fusion);
[[nodiscard]] DELOS_API const char* to_string(CovarianceKind kind);

/// The pose of a placement in the frame that it is given in: X_GS, X_WG, or that of an
/// occluder in the world or in the target.
[[nodiscard]] DELOS_API Pose pose_of(const Placement& placement);

/// The beacons of a set that are lit, in the order of the grid, x fastest, or the list.
[[nodiscard]] DELOS_API std::vector<Beacon> lit_beacons(const BeaconSet& set);

/// The body as triangles in its own frame, metres: scaled, not placed.
/// @pre the body came from a loaded scene, or would pass the loader's checks
[[nodiscard]] DELOS_API TriangleMesh body_mesh(const Body& body);

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
/// @throws std::domain_error one sentence: the ray of a mesh surface hits nothing there
[[nodiscard]] DELOS_API Pose device_pose(const Scene& scene, const DeviceEntry& device);

}  // namespace delos
