#include "rig/sight.h"

#include <algorithm>

namespace delos {
namespace {

Sight sight_from(const Occluders& occluders, const Eigen::Vector3d& apex,
                 const Eigen::AlignedBox3d& box, double skin) {
  if (occluders.triangles() == 0 || !occluders.touches_shaft(apex, box)) {
    return Sight::clear;
  }
  return occluders.hides(apex, box, skin) ? Sight::hidden : Sight::unknown;
}

/// The box around a turned box.
Eigen::AlignedBox3d turned(const Eigen::Matrix3d& R, const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d middle = R * box.center();
  const Eigen::Vector3d half = R.cwiseAbs() * box.sizes() / 2;
  return {middle - half, middle + half};
}

/// Whether a marker faces the device from all over a box, by the ball around it.
Sight faced_by_box(const Eigen::Vector3d& device, const Eigen::Matrix3d& R_WT,
                   const PlacedMarker& marker, const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d way = R_WT.transpose() * (device - box.center()) - marker.p;
  // Rounding may not turn a touch into a certainty.
  const double radius = box.diagonal().norm() / 2 + 1e-9 * way.norm();
  const double margin = marker.margin(way);
  if (margin < -radius) return Sight::hidden;
  return margin > radius ? Sight::clear : Sight::unknown;
}

}  // namespace

bool may_be_hidden(const System& system, const PlacedDevice& placed) {
  return placed.device->needs_sight() &&
         (system.in_world.triangles() + system.on_target.triangles() > 0 ||
          std::any_of(system.markers.begin(), system.markers.end(),
                      [](const PlacedMarker& m) { return !m.faces_all_ways(); }));
}

bool in_sight(const System& system, const Eigen::Vector3d& in_world,
              const TargetPose& X_WT, const Eigen::Vector3d& arm) {
  if (system.in_world.triangles() > 0 &&
      system.in_world.blocks(in_world, X_WT.p + arm, system.skin)) {
    return false;
  }
  if (system.on_target.triangles() == 0) return true;
  const Eigen::Matrix3d R_TW = X_WT.R.transpose();
  return !system.on_target.blocks(R_TW * (in_world - X_WT.p), R_TW * arm, system.skin);
}

bool in_sight(const System& system, const PlacedDevice& placed, const TargetPose& X_WT,
              const PlacedMarker& marker) {
  return std::all_of(
      placed.lenses.begin(), placed.lenses.end(), [&](const Eigen::Vector3d& in_S) {
        const Eigen::Vector3d lens = placed.X_WS() * in_S;
        return (marker.faces_all_ways() ||
                marker.margin(X_WT.R.transpose() * (lens - X_WT.p) - marker.p) >= 0) &&
               in_sight(system, lens, X_WT, Eigen::Vector3d(X_WT.R * marker.p));
      });
}

namespace {

/// Of one lens, in W.
Sight sight_of_box(const System& system, const Eigen::Vector3d& device,
                   const Eigen::Matrix3d& R_WT, const PlacedMarker& marker,
                   const Eigen::AlignedBox3d& box) {
  const Eigen::Vector3d arm = R_WT * marker.p;
  if (!marker.faces_all_ways()) {
    // Where it isn't known, what else hides isn't asked.
    const Sight faces = faced_by_box(device, R_WT, marker, box);
    if (faces != Sight::clear) return faces;
  }
  const Sight world = sight_from(system.in_world, device,
                                 {box.min() + arm, box.max() + arm}, system.skin);
  if (world == Sight::hidden || system.on_target.triangles() == 0) return world;
  // Seen from the target, the marker stays and the device moves through a box.
  const Eigen::Matrix3d R_TW = R_WT.transpose();
  const Eigen::AlignedBox3d devices =
      turned(R_TW, {device - box.max(), device - box.min()});
  const Sight target = sight_from(system.on_target, R_TW * arm, devices, system.skin);
  if (target == Sight::hidden) return target;
  return world == Sight::clear ? target : Sight::unknown;
}

}  // namespace

Sight sight_of_box(const System& system, const PlacedDevice& placed,
                   const Eigen::Matrix3d& R_WT, const PlacedMarker& marker,
                   const Eigen::AlignedBox3d& box) {
  Sight all = Sight::clear;
  for (const Eigen::Vector3d& in_S : placed.lenses) {
    const Sight one =
        sight_of_box(system, Eigen::Vector3d(placed.X_WS() * in_S), R_WT, marker, box);
    if (one == Sight::hidden) return one;
    if (one == Sight::unknown) all = one;
  }
  return all;
}

bool inside_solid(const System& system, const Eigen::Vector3d& p) {
  return system.in_world.triangles() > 0 && system.in_world.contains(p);
}

bool deep_inside_solid(const System& system, const Eigen::Vector3d& p) {
  const Eigen::Vector3d skin = Eigen::Vector3d::Constant(system.skin);
  // The shaft from a point to a box around it is that box.
  return inside_solid(system, p) &&
         !system.in_world.touches_shaft(p, {p - skin, p + skin});
}

std::vector<unsigned char> inside_solids(const System& system, const Samples& samples) {
  std::vector<unsigned char> inside;
  if (system.in_world.triangles() == 0) return inside;
  inside.reserve(samples.points.size());
  for (const SamplePart& part : samples.parts) {
    const bool chosen = std::holds_alternative<ScatteredShape>(part.shape) ||
                        std::holds_alternative<SurfaceShape>(part.shape);
    for (std::size_t i = part.first; i < part.first + part.count; ++i) {
      const Eigen::Vector3d& p = samples.points[i];
      inside.push_back(chosen ? deep_inside_solid(system, p) : inside_solid(system, p));
    }
  }
  return inside;
}

}  // namespace delos
