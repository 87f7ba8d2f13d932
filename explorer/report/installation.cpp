#include "report/installation.h"

#include <algorithm>
#include <cmath>

#include "session/description.h"
#include "session/view_outline.h"

namespace delos::report {
namespace {

using session::Json;

/// The point of an axis nearest to one that is looked at.
Eigen::Vector3d aim_of(const DeviceEntry& entry, const Pose& X_WS,
                       const Eigen::Vector3d& middle) {
  const auto* aim = std::get_if<Aim>(&entry.placement.facing);
  const bool in_the_world = entry.group.empty() && !entry.mounting;
  const Eigen::Vector3d target = aim && in_the_world ? aim->at : middle;
  const Eigen::Vector3d ahead = X_WS.R.col(2);
  return X_WS.p + std::max(0.0, ahead.dot(target - X_WS.p)) * ahead;
}

InstalledDevice installed(const DeviceEntry& entry, const PlacedDevice& device,
                          const Eigen::Vector3d& middle) {
  const Pose& X_WS = device.X_WS();
  InstalledDevice all;
  all.name = device.name;
  all.at = X_WS.p;
  const double half_way = std::max((middle - X_WS.p).norm() / 2, 1e-3);
  for (const Eigen::Vector3d& p : session::view_outline(*device.device, half_way))
    all.view.push_back(X_WS * p);
  if (all.view.empty()) return all;  // no direction that one could set
  all.aim = aim_of(entry, X_WS, middle);
  all.facing = facing_of(X_WS.R);
  return all;
}

Json box_json(const Eigen::AlignedBox3d& box) {
  return {{"min", session::numbers(box.min())}, {"max", session::numbers(box.max())}};
}

Json device_json(const InstalledDevice& device) {
  Json from = Json::array(), view = Json::array();
  for (const FromWall& f : device.from)
    from.push_back({{"wall", f.wall}, {"distance", session::number(f.distance)}});
  for (const Eigen::Vector3d& p : device.view) view.push_back(session::numbers(p));
  const auto angle = [&](double value) {
    return device.aim ? session::number(value) : Json();
  };
  return {{"name", device.name},
          {"at", session::numbers(device.at)},
          {"from", from},
          {"aim", device.aim ? session::numbers(*device.aim) : Json()},
          {"pan", angle(device.facing.pan)},
          {"tilt", angle(device.facing.tilt)},
          {"roll", angle(device.facing.roll)},
          {"view", view}};
}

}  // namespace

Facing facing_of(const Eigen::Matrix3d& R_WS) {
  const Eigen::Vector3d ahead = R_WS.col(2);
  const double level = ahead.head<2>().norm();
  Facing facing;
  facing.tilt = std::atan2(ahead.z(), level);
  if (level < 1e-9) {
    const Eigen::Vector3d upper = -R_WS.col(1);
    facing.pan = std::atan2(upper.y(), upper.x());
    return facing;
  }
  facing.pan = std::atan2(ahead.y(), ahead.x());
  // Level, to the right as seen from behind, and down across that.
  const Eigen::Vector3d right = Eigen::Vector3d(ahead.y(), -ahead.x(), 0) / level;
  const Eigen::Vector3d down = ahead.cross(right);
  facing.roll = std::atan2(R_WS.col(0).dot(down), R_WS.col(0).dot(right));
  return facing;
}

std::optional<Eigen::AlignedBox3d> walls_of(const Scene& scene) {
  Eigen::AlignedBox3d walls;
  for (const OccluderEntry& entry : scene.occluders) {
    if (!entry.room || entry.mount == Mount::target) continue;
    for (const Eigen::Vector3d& p :
         transformed(body_mesh(entry.body), pose_of(entry.placement)).vertices)
      walls.extend(p);
  }
  if (walls.isEmpty()) return std::nullopt;
  return walls;
}

std::vector<FromWall> from_walls(const Eigen::Vector3d& p,
                                 const Eigen::AlignedBox3d& walls) {
  const auto nearer = [&](int k, const char* low, const char* high) {
    const double from = p[k] - walls.min()[k], to = walls.max()[k] - p[k];
    return from <= to ? FromWall{low, from} : FromWall{high, to};
  };
  return {nearer(0, "left", "right"),
          nearer(1, "front", "back"),
          {"floor", p.z() - walls.min().z()}};
}

Installation installation_of(const Scene& scene, const System& system) {
  Installation all{walls_of(scene), session::sample_box(scene), {}};
  const Eigen::Vector3d middle = all.samples.isEmpty() ? Eigen::Vector3d::Zero().eval()
                                                       : all.samples.center().eval();
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    if (system.devices[i].carried()) continue;
    all.devices.push_back(installed(scene.devices[i], system.devices[i], middle));
    InstalledDevice& device = all.devices.back();
    if (all.walls) device.from = from_walls(device.at, *all.walls);
  }
  return all;
}

Json installation_json(const Installation& installation) {
  Json devices = Json::array();
  for (const InstalledDevice& device : installation.devices)
    devices.push_back(device_json(device));
  return {{"walls", installation.walls ? box_json(*installation.walls) : Json()},
          {"samples", box_json(installation.samples)},
          {"devices", devices}};
}

}  // namespace delos::report
