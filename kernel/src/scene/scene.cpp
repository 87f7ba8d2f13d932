#include "delos/scene/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>

#include "delos/device/faults.h"
#include "scene/words.h"

namespace delos {

Scene::Scene() = default;
Scene::Scene(const Scene&) = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(const Scene&) = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;
bool Scene::operator==(const Scene&) const = default;

const char* to_string(Fusion fusion) { return word_of(kFusionWords, fusion); }
const char* to_string(CovarianceKind kind) { return word_of(kCovarianceWords, kind); }
const char* to_string(ErrorPart part) { return word_of(kErrorPartWords, part); }

Pose pose_of(const Placement& placement) {
  Pose pose;
  pose.p = placement.at;
  if (const auto* rpy = std::get_if<Rpy>(&placement.facing))
    pose.R = rotation_from_rpy(rpy->angles);
  if (const auto* q = std::get_if<QuaternionWxyz>(&placement.facing)) {
    // Scaled first, so that the square of its length can't overflow or vanish.
    const Eigen::Vector4d u = q->wxyz.stableNormalized();
    pose.R = Eigen::Quaterniond(u[0], u[1], u[2], u[3]).toRotationMatrix();
  }
  if (const auto* aim = std::get_if<Aim>(&placement.facing))
    pose.R =
        rotation_from_aim(placement.at, aim->at) * rotation_from_rpy({0, 0, aim->roll});
  return pose;
}

namespace {

Pose mounted_pose(const Scene& scene, const DeviceEntry& device) {
  const auto surface = std::find_if(
      scene.surfaces.begin(), scene.surfaces.end(),
      [&](const SurfaceEntry& s) { return s.name == device.mounting->surface; });
  if (surface == scene.surfaces.end()) std::abort();
  const auto point = mount_point(*surface, device.mounting->coordinates);
  if (!point)
    throw Unbuildable(device.name + ": the ray from its coordinates on '" +
                      surface->name + "' hits nothing");
  Placement placement = device.placement;
  placement.at = point->p;
  Pose X_WS = pose_of(placement);
  if (point->normal && std::holds_alternative<std::monostate>(placement.facing))
    X_WS.R = rotation_from_aim(Eigen::Vector3d::Zero(), *point->normal);
  return X_WS;
}

}  // namespace

Pose device_pose(const Scene& scene, const DeviceEntry& device) {
  if (device.mounting) return mounted_pose(scene, device);
  const Pose X_GS = pose_of(device.placement);
  if (device.group.empty()) return X_GS;
  const auto group =
      std::find_if(scene.groups.begin(), scene.groups.end(),
                   [&](const Group& g) { return g.name == device.group; });
  if (group == scene.groups.end()) std::abort();
  return pose_of(group->placement) * X_GS;
}

}  // namespace delos
