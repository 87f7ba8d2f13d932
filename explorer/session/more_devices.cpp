#include "session/more_devices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "delos/scene/io.h"
#include "delos/text/units.h"
#include "session/description.h"
#include "session/palette.h"
#include "session/placing.h"

namespace delos::session {
namespace {

constexpr double kUsualRate = 60;  ///< updates a second, where no device has another

const DeviceEntry* device_of(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.devices.begin(), scene.devices.end(),
                                  [&](const DeviceEntry& d) { return d.name == name; });
  return found == scene.devices.end() ? nullptr : &*found;
}

std::string there_is_no(const std::string& device) {
  return "there is no device '" + device + "'";
}

std::string vector_text(const Eigen::Vector3d& v) {
  return "[" + shortest(v.x()) + ", " + shortest(v.y()) + ", " + shortest(v.z()) + "]";
}

/// The turn about the z axis, from x towards y, between two frames that share it.
double roll_between(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  return std::atan2(to.col(0).dot(from.col(1)), to.col(0).dot(from.col(0)));
}

/// Whether devices of a plugin are there to be carried below beacons: in the world,
/// where they could stand, they would wait for the target to come by.
bool looks_at_beacons(const std::string& type) { return type == "hiball"; }

/// Beacons on a ceiling that is at least a hand's reach above the samples, and so much
/// wider than they are that slanted views meet it, too.
Override ceiling_over(const Eigen::AlignedBox3d& samples,
                      const Eigen::AlignedBox3d& room) {
  constexpr double kReach = 0.8, kStep = 0.1, kMostAlong = 60;
  const double z = std::max(room.max().z(), samples.max().z() + kReach);
  const double margin = z - samples.min().z();
  Eigen::Vector3d low = samples.min(), high = samples.max();
  low.head<2>().array() -= margin;
  high.head<2>().array() += margin;
  low.z() = high.z() = z;
  const double widest = (high - low).maxCoeff();
  const double step = std::max(kStep, std::ceil(10 * widest / kMostAlong) / 10);
  return {"beacons.ceiling",
          "{grid: {min: " + vector_text(low) + ", max: " + vector_text(high) +
              ", step: " + shortest(step) + "}, normal: [0, 0, -1], pattern: full}"};
}

/// Copies of a device that stands in the world, each where it is put.
/// @param put the pose of the k-th, from that of the first
template <class Put>
Together copied(const LoadedScene& loaded, const std::string& device, int copies,
                Put put) {
  const DeviceEntry* like = device_of(loaded.scene, device);
  if (!like) return there_is_no(device);
  if (copies < 1 || copies > kMostCopies)
    return "there can be 1 to " + std::to_string(kMostCopies) + " copies at once";
  if (like->mount == Mount::target)
    return device + " is carried by the target, where it has no row or circle";
  const Pose X_WS = device_pose(loaded.scene, *like);
  const Pose X_GW = group_frame(loaded.scene, like->group).inverse();
  Scene grown = loaded.scene;  // so that each copy has a name of its own
  std::vector<Override> changes;
  for (int k = 1; k <= copies; ++k) {
    DeviceEntry copy = *device_of(grown, device);
    copy.name = free_name(grown, device);
    copy.mounting.reset();
    copy.placement = placed_like(copy.placement, X_GW * put(X_WS, k));
    changes.push_back(device_override(copy));
    grown.devices.push_back(std::move(copy));
  }
  return changes;
}

}  // namespace

std::string free_name(const Scene& scene, const std::string& like) {
  std::string base = like;
  const std::size_t mark = base.find_last_not_of("0123456789");
  if (mark != std::string::npos && mark + 1 < base.size() && mark > 0 &&
      base[mark] == '_')
    base.resize(mark);
  for (int n = 2;; ++n) {
    std::string name = base + "_" + std::to_string(n);
    if (!device_of(scene, name)) return name;
  }
}

Placement placed_like(const Placement& like, const Pose& pose) {
  Placement placement{pose.p, {}};
  if (const auto* aim = std::get_if<Aim>(&like.facing)) {
    const double distance = (aim->at - like.at).norm();
    const Eigen::Vector3d at = pose.p + distance * pose.R.col(2);
    placement.facing = Aim{at, roll_between(rotation_from_aim(pose.p, at), pose.R)};
  } else if (std::holds_alternative<QuaternionWxyz>(like.facing)) {
    const Eigen::Quaterniond q(pose.R);
    placement.facing = QuaternionWxyz{{q.w(), q.x(), q.y(), q.z()}};
  } else if (!pose.R.isIdentity(1e-12)) {
    placement.facing = Rpy{rpy_of(pose.R)};
  }
  return placement;
}

Ways adding(const LoadedScene& loaded, const std::string& type,
            const std::string& preset, const std::optional<Eigen::Vector3d>& at,
            PluginRegistry& plugins) {
  const PluginLoad& plugin = plugins.find(type);
  if (!plugin.info) return plugin.error;
  const std::string params =
      preset.empty() ? first_params(*plugin.info) : preset_params(type, preset);
  if (params.empty())
    return preset.empty()
               ? type + " has parameters without a default, and no example of them"
               : "there is no " + type + " '" + preset + "'";
  const Scene& scene = loaded.scene;
  const Eigen::AlignedBox3d samples = sample_box(scene), room = room_box(loaded);
  const Eigen::Vector3d middle = samples.center();
  const Eigen::Vector3d place =
      at.value_or(Eigen::Vector3d(middle.x(), middle.y(), room.max().z()));
  const double rate =
      scene.devices.empty() ? kUsualRate : rate_of(scene.devices.front());
  const std::string head = "{name: " + free_name(scene, type) + ", type: " + type +
                           ", rate: " + shortest(rate) + ", params: " + params;
  const bool apart = (place - middle).norm() > 1e-6;
  const Override standing{"devices.+",
                          head + ", at: " + vector_text(place) +
                              (apart ? ", aim: " + vector_text(middle) : "") + "}"};
  const Override carried{"devices.+", head + ", mount: target}"};
  if (looks_at_beacons(type) && !scene.beacons.empty())
    return std::vector<std::vector<Override>>{{carried}};
  if (looks_at_beacons(type))
    return std::vector<std::vector<Override>>{{ceiling_over(samples, room), carried}};
  std::vector<std::vector<Override>> ways{{standing}, {carried}};
  if (scene.beacons.empty()) ways.push_back({ceiling_over(samples, room), carried});
  return ways;
}

Ways copying(const LoadedScene& loaded, const std::string& device,
             const Eigen::Vector3d& by) {
  const DeviceEntry* like = device_of(loaded.scene, device);
  if (!like) return there_is_no(device);
  DeviceEntry copy = *like;
  copy.name = free_name(loaded.scene, device);
  if (copy.mount == Mount::world && !copy.mounting) {
    const Pose frame = group_frame(loaded.scene, copy.group);
    const Eigen::Vector3d step = frame.R.transpose() * by;
    copy.placement.at += step;
    // It goes on looking the same way.
    if (auto* aim = std::get_if<Aim>(&copy.placement.facing)) aim->at += step;
  }
  return std::vector<std::vector<Override>>{{device_override(copy)}};
}

// A mirror M = I − 2 e eᵀ turns right-handed frames into left-handed ones; mirrored
// once more along the device's own x axis, its z axis stays where the mirror shows it:
// R′ = M R diag(−1, 1, 1).
Ways mirroring(const LoadedScene& loaded, const std::string& device, int axis) {
  const Scene& scene = loaded.scene;
  const DeviceEntry* like = device_of(scene, device);
  if (!like) return there_is_no(device);
  if (like->mount == Mount::target)
    return device + " is carried by the target, which has no mirror in the room";
  Pose X_WS = device_pose(scene, *like);
  const double middle = sample_box(scene).center()(axis);
  X_WS.p(axis) = 2 * middle - X_WS.p(axis);
  X_WS.R.row(axis) *= -1;
  X_WS.R.col(0) *= -1;
  DeviceEntry copy = *like;
  copy.name = free_name(scene, device);
  copy.mounting.reset();
  const Pose X_GS = group_frame(scene, copy.group).inverse() * X_WS;
  copy.placement = placed_like(like->placement, X_GS);
  return std::vector<std::vector<Override>>{{device_override(copy)}};
}

Together in_a_row(const LoadedScene& loaded, const std::string& device, int copies,
                  const Eigen::Vector3d& by) {
  return copied(loaded, device, copies, [&](const Pose& X_WS, int k) {
    return Pose{X_WS.R, X_WS.p + k * by};
  });
}

Together in_a_circle(const LoadedScene& loaded, const std::string& device, int copies,
                     const Eigen::Vector3d& centre) {
  return copied(loaded, device, copies, [&](const Pose& X_WS, int k) {
    const double angle = 2 * std::numbers::pi * k / (copies + 1);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    return Pose{turn * X_WS.R, centre + turn * (X_WS.p - centre)};
  });
}

Ways removing(const LoadedScene& loaded, const std::string& device) {
  if (!device_of(loaded.scene, device)) return there_is_no(device);
  if (loaded.scene.devices.size() == 1)
    return device + " is the only device: without it nothing is measured";
  return std::vector<std::vector<Override>>{{{"devices.-", device}}};
}

}  // namespace delos::session
