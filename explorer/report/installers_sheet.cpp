#include "report/installers_sheet.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "report/rig_figure.h"
#include "session/description.h"
#include "session/view_outline.h"

namespace delos::report {
namespace {

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text.setf(std::ios::fixed);
  text.precision(digits);
  const double least = std::pow(10, -digits) / 2;
  text << (std::abs(value) < least ? 0.0 : value);
  return text.str();
}

std::string millimetres(const Eigen::Vector3d& p) {
  return fixed(p.x(), 3) + ", " + fixed(p.y(), 3) + ", " + fixed(p.z(), 3);
}

std::string degrees(double angle) {
  return fixed(angle * 180 / std::numbers::pi, 1) + "°";
}

/// From its nearer wall across x, across y, and from the floor.
std::string from_walls(const Eigen::Vector3d& p, const Eigen::AlignedBox3d& walls) {
  const auto side = [&](int k, const char* low, const char* high) {
    const double from = p[k] - walls.min()[k], to = walls.max()[k] - p[k];
    return fixed(std::min(from, to), 3) + (from <= to ? low : high);
  };
  return side(0, " left, ", " right, ") + side(1, " front, ", " back, ") +
         fixed(p.z() - walls.min().z(), 3) + " up";
}

/// Where a device looks all around it has no direction that one could set.
bool has_direction(const PlacedDevice& device) {
  return !session::view_outline(*device.device, 1).empty();
}

Eigen::Vector3d middle_of(const Scene& scene) {
  const Eigen::AlignedBox3d box = session::sample_box(scene);
  return box.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(box.center());
}

/// The point of an axis nearest to one that is looked at.
Eigen::Vector3d aim_of(const DeviceEntry& entry, const Pose& X_WS,
                       const Eigen::Vector3d& middle) {
  const auto* aim = std::get_if<Aim>(&entry.placement.facing);
  const bool in_the_world = entry.group.empty() && !entry.mounting;
  const Eigen::Vector3d target = aim && in_the_world ? aim->at : middle;
  const Eigen::Vector3d ahead = X_WS.R.col(2);
  return X_WS.p + std::max(0.0, ahead.dot(target - X_WS.p)) * ahead;
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

Html installers_sheet(const Scene& scene, const System& system) {
  const std::optional<Eigen::AlignedBox3d> walls = walls_of(scene);
  const Eigen::Vector3d middle = middle_of(scene);
  std::vector<std::vector<Html>> rows;
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    const PlacedDevice& device = system.devices[i];
    if (device.carried()) continue;
    const Pose& X_WS = device.X_WS();
    std::vector<Html> row{device.name, millimetres(X_WS.p)};
    if (walls) row.push_back(from_walls(X_WS.p, *walls));
    if (has_direction(device)) {
      const Facing f = facing_of(X_WS.R);
      row.insert(row.end(), {millimetres(aim_of(scene.devices[i], X_WS, middle)),
                             degrees(f.pan), degrees(f.tilt), degrees(f.roll)});
    } else {
      row.insert(row.end(), {"all around", "", "", ""});
    }
    rows.push_back(std::move(row));
  }
  if (rows.empty()) return element("p", "The target carries all devices.");
  std::vector<Html> head{"device", "x, y, z [m]"};
  if (walls) head.emplace_back("from the walls [m]");
  for (const char* name : {"aim [m]", "pan", "tilt", "roll"}) head.emplace_back(name);
  const std::string frame =
      walls
          ? " Walls are those of the scene's room: left and right across x, front and "
            "back across y, the nearer one of each; heights are above its floor."
          : " The scene has no room: measure from where its x, y and z begin.";
  return Html::markup(rig_figure(scene, system)) +
         table(
             "Where each device is to stand and look. Pan is from x towards y, tilt "
             "above the horizon, roll clockwise as seen from behind; the aim is the "
             "point of its axis nearest to what it looks at." +
                 frame,
             head, rows);
}

}  // namespace delos::report
