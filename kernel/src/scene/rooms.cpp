#include "scene/rooms.h"

#include <algorithm>

#include "delos/geometry/occluders.h"
#include "delos/scene/places.h"

namespace delos {
namespace {

/// Whether a closed mesh of one orientation faces inward: its signed volume,
///
///   V = Σ a · (b × c) / 6   over the triangles (a, b, c),
///
/// is negative.
bool faces_inward(const TriangleMesh& mesh) {
  const Eigen::Vector3d& origin = mesh.vertices.front();
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += (mesh.vertices[a] - origin)
                  .dot((mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin));
  return volume < 0;
}

/// Where the devices of the world stand, and some of the places of the target.
std::vector<Eigen::Vector3d> all_places(const Scene& scene) {
  constexpr std::size_t kMost = 1000;
  std::vector<Eigen::Vector3d> places;
  for (const DeviceEntry& device : scene.devices)
    if (device.mount == Mount::world) places.push_back(device_pose(scene, device).p);
  for (const Pose& pose : spread_poses(scene, kMost)) places.push_back(pose.p);
  return places;
}

}  // namespace

void find_rooms(Reader& reader, const Place& at, Scene& scene) {
  for (std::size_t i = 0; i < scene.occluders.size(); ++i) {
    OccluderEntry& entry = scene.occluders[i];
    const auto* shape = std::get_if<MeshShape>(&entry.body);
    if (!shape || entry.room || entry.mount != Mount::world) continue;
    if (!faces_inward(*shape->mesh)) continue;
    const Occluders body(
        {transformed(body_mesh(entry.body), pose_of(entry.placement))});
    const std::vector<Eigen::Vector3d> places = all_places(scene);
    if (!std::all_of(places.begin(), places.end(),
                     [&](const auto& p) { return body.contains(p); }))
      continue;
    entry.room = true;
    const Node& node = at.node().items[i];
    reader.warning(Place(at, member_name(node, i), node),
                   "faces inward and holds all devices and samples: it is taken for a "
                   "room, whose inside is free; say so with 'room: true'");
  }
}

}  // namespace delos
