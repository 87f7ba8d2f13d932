#include "session/placing.h"

#include <algorithm>
#include <cmath>

#include "delos/text/units.h"

namespace delos::session {
namespace {

template <class Vector>
std::string list_text(const Vector& v) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < v.size(); ++i)
    text += (i > 0 ? ", " : "") + shortest(v(i));
  return text + "]";
}

/// How the placement would say where it faces. @param X_GS wanted
Override facing(const std::string& path, const Placement& placement, const Pose& X_GS) {
  if (const auto* aim = std::get_if<Aim>(&placement.facing)) {
    const double distance = (aim->at - placement.at).norm();
    return {path + ".aim",
            list_text(Eigen::Vector3d(X_GS.p + distance * X_GS.R.col(2)))};
  }
  if (std::holds_alternative<QuaternionWxyz>(placement.facing)) {
    const Eigen::Quaterniond q(X_GS.R);
    return {path + ".quaternion_wxyz",
            list_text(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()))};
  }
  return {path + ".rpy", list_text(rpy_of(X_GS.R))};
}

}  // namespace

Pose group_frame(const Scene& scene, const std::string& group) {
  for (const Group& known : scene.groups)
    if (known.name == group) return pose_of(known.placement);
  return {};
}

// R = Rz(yaw)·Ry(pitch)·Rx(roll): its first column is (cy cp, sy cp, −sp), its last row
// (−sp, cp sr, cp cr). Where cp = 0 only yaw ∓ roll is there to be found.
Eigen::Vector3d rpy_of(const Eigen::Matrix3d& R) {
  constexpr double kUpright = 1e-9;
  const double cos_pitch = std::hypot(R(0, 0), R(1, 0));
  const double pitch = std::atan2(-R(2, 0), cos_pitch);
  if (cos_pitch < kUpright) return {0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

std::variant<std::vector<Override>, std::string> placing(
    const Scene& scene, const std::string& device,
    const std::optional<Eigen::Vector3d>& p, const std::optional<Eigen::Matrix3d>& R) {
  const auto entry =
      std::find_if(scene.devices.begin(), scene.devices.end(),
                   [&](const DeviceEntry& d) { return d.name == device; });
  if (entry == scene.devices.end()) return "there is no device '" + device + "'";
  if (entry->mount == Mount::target)
    return device + " is carried by the target: type its place in the target's frame";
  if (entry->mounting && p)
    return device + " is mounted on '" + entry->mounting->surface +
           "': change its coordinates there";

  Pose X_WS = device_pose(scene, *entry);
  if (p) X_WS.p = *p;
  if (R) X_WS.R = *R;
  const Pose X_GS = group_frame(scene, entry->group).inverse() * X_WS;
  const std::string path = "devices." + device;
  std::vector<Override> changes;
  if (p) changes.push_back({path + ".at", list_text(X_GS.p)});
  if (R) changes.push_back(facing(path, entry->placement, X_GS));
  return changes;
}

}  // namespace delos::session
