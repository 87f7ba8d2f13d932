#include "delos/rig/system.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace delos {
namespace {

Fusion default_fusion(const Scene& scene) {
  const bool one_rate = std::all_of(
      scene.devices.begin(), scene.devices.end(),
      [&](const DeviceEntry& d) { return d.rate == scene.devices.front().rate; });
  return one_rate ? Fusion::stacked : Fusion::continuous;
}

std::shared_ptr<const Device> reuse(const System* previous, std::size_t index,
                                    const DeviceEntry& entry) {
  if (!previous || index >= previous->devices.size()) return nullptr;
  const PlacedDevice& old = previous->devices[index];
  return old.type == entry.type && old.params == entry.params ? old.device : nullptr;
}

/// The index of the beacons that a device sees.
std::shared_ptr<const BeaconIndex> beacons_of(const Scene& scene,
                                              const DeviceEntry& entry) {
  std::vector<Beacon> all;
  for (const BeaconSet& set : scene.beacons) {
    const auto& sees = entry.beacons;
    if (!sees.empty() && std::find(sees.begin(), sees.end(), set.name) == sees.end()) {
      continue;
    }
    const std::vector<Beacon> lit = lit_beacons(set);
    all.insert(all.end(), lit.begin(), lit.end());
  }
  return std::make_shared<const BeaconIndex>(std::move(all));
}

/// The same, shared with the previous system and with devices of the same sets.
class BeaconSharing {
 public:
  BeaconSharing(const Scene& scene, const System* previous)
      : scene_(scene),
        previous_(previous && previous->beacon_sets == scene.beacons ? previous
                                                                     : nullptr) {}

  std::shared_ptr<const BeaconIndex> operator()(std::size_t index,
                                                const DeviceEntry& entry) {
    if (previous_ && index < previous_->devices.size()) {
      const PlacedDevice& old = previous_->devices[index];
      if (old.beacons && old.sees == entry.beacons) return old.beacons;
    }
    auto& made = made_[entry.beacons];
    if (!made) made = beacons_of(scene_, entry);
    return made;
  }

 private:
  const Scene& scene_;
  const System* previous_;
  std::map<std::vector<std::string>, std::shared_ptr<const BeaconIndex>> made_;
};

TriangleMesh placed_mesh(const OccluderEntry& entry) {
  return transformed(body_mesh(entry.body), pose_of(entry.placement));
}

/// The bodies of one mount, placed.
Occluders placed_occluders(const Scene& scene, Mount mount) {
  std::vector<TriangleMesh> bodies;
  std::vector<char> rooms;
  for (const OccluderEntry& entry : scene.occluders) {
    if (entry.mount != mount) continue;
    bodies.push_back(placed_mesh(entry));
    rooms.push_back(entry.room);
  }
  return bodies.empty() ? Occluders() : Occluders(bodies, rooms);
}

}  // namespace

Occluders placed_body(const OccluderEntry& entry) {
  return Occluders({placed_mesh(entry)}, {entry.room});
}

System build_system(const Scene& scene, PluginRegistry& plugins,
                    const System* previous) {
  System system;
  system.motion = scene.motion;
  system.fusion = scene.fusion.value_or(default_fusion(scene));
  system.covariance = scene.covariance;
  system.markers = scene.markers;
  system.skin = scene.skin;
  system.occluders = scene.occluders;
  if (previous && previous->occluders == scene.occluders) {
    system.in_world = previous->in_world;
    system.on_target = previous->on_target;
  } else {
    system.in_world = placed_occluders(scene, Mount::world);
    system.on_target = placed_occluders(scene, Mount::target);
  }
  system.beacon_sets = scene.beacons;
  BeaconSharing beacons(scene, previous);
  system.devices.reserve(scene.devices.size());
  for (const DeviceEntry& entry : scene.devices) {
    PlacedDevice placed;
    placed.name = entry.name;
    placed.type = entry.type;
    placed.params = entry.params;
    placed.device = reuse(previous, system.devices.size(), entry);
    if (!placed.device) {
      const PluginLoad& plugin = plugins.find(entry.type);
      if (!plugin.info) throw std::runtime_error(plugin.error);
      placed.device = make_device(*plugin.info, entry.params);
    }
    if (entry.mount == Mount::target) {
      placed.X_TS = pose_of(entry.placement);
      placed.beacons = beacons(system.devices.size(), entry);
      placed.sees = entry.beacons;
      placed.select = entry.select;
      placed.count = entry.count;
    } else {
      placed.X_WS = device_pose(scene, entry);
    }
    placed.period = 1 / entry.rate;
    placed.phase = entry.phase;
    system.devices.push_back(std::move(placed));
  }
  return system;
}

int information_size(const System& system) {
  const StateLayout& layout = system.motion.layout;
  const bool pose_alone = std::all_of(
      system.devices.begin(), system.devices.end(), [](const PlacedDevice& d) {
        const Span span = d.device->span();
        return span == Span::point || span == Span::pose;
      });
  return pose_alone ? layout.coordinates() : layout.size();
}

}  // namespace delos
