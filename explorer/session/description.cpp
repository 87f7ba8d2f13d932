#include "session/description.h"

#include <algorithm>

#include "delos/device/beacons.h"
#include "delos/scene/clutter.h"
#include "delos/scene/definition.h"
#include "session/parameter_table.h"
#include "session/scene_field.h"
#include "session/view_outline.h"

namespace delos::session {
namespace {

Json value_json(const ParamValue& value) {
  if (const auto* one = std::get_if<double>(&value)) return number(*one);
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  const auto& matrix = std::get<Eigen::MatrixXd>(value);
  return matrix.cols() == 1 ? numbers(matrix.col(0)) : rows(matrix);
}

/// The scene's key of an orientation, and its numbers.
std::pair<const char*, Json> facing_json(const Placement& placement) {
  if (const auto* aim = std::get_if<Aim>(&placement.facing))
    return {"aim", numbers(aim->at)};
  if (const auto* rpy = std::get_if<Rpy>(&placement.facing))
    return {"rpy", numbers(rpy->angles)};
  if (const auto* q = std::get_if<QuaternionWxyz>(&placement.facing))
    return {"quaternion_wxyz", numbers(q->wxyz)};
  return {"", Json::array()};
}

/// Outlines of devices; those of equal kind are worked out once.
class Outlines {
 public:
  explicit Outlines(double depth) : depth_(depth) {}

  const Json& of(const PlacedDevice& device) {
    for (const auto& [like, outline] : known_)
      if (like->type == device.type && like->params == device.params) return outline;
    Json points = Json::array();
    for (const Eigen::Vector3d& p : view_outline(*device.device, depth_))
      points.push_back(numbers(p));
    return known_.emplace_back(&device, std::move(points)).second;
  }

 private:
  double depth_;
  std::vector<std::pair<const PlacedDevice*, Json>> known_;
};

Json device_json(const DeviceEntry& entry, const PlacedDevice& placed,
                 Outlines& outlines) {
  const auto [facing, value] = facing_json(entry.placement);
  Json json{{"name", entry.name},
            {"type", entry.type},
            {"rate", rate_of(entry)},
            {"mount", entry.mount == Mount::target ? "target" : "world"},
            {"group", entry.group},
            {"at", numbers(entry.placement.at)},
            {"facing", facing},
            {"value", value}};
  if (entry.mounting) {
    json["surface"] = entry.mounting->surface;
    json["coordinates"] = entry.mounting->coordinates;
  }
  if (!placed.carried()) {
    json["pose"] = {{"p", numbers(placed.X_WS().p)}, {"R", rows(placed.X_WS().R)}};
    json["outline"] = outlines.of(placed);
  }
  json["params"] = Json::object();
  for (const auto& [name, parameter] : entry.params.all())
    json["params"][name] = value_json(parameter);
  return json;
}

/// Triangles of a body, placed: those on the target stand in its frame.
Json mesh_json(const TriangleMesh& mesh) {
  Json vertices = Json::array(), triangles = Json::array();
  for (const Eigen::Vector3d& p : mesh.vertices)
    for (const double x : p) vertices.push_back(static_cast<float>(x));
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) triangles.push_back(corner);
  return {{"vertices", std::move(vertices)}, {"triangles", std::move(triangles)}};
}

template <class Entry>
Json body_json(const Entry& entry, const std::string& path) {
  const TriangleMesh own = body_mesh(entry.body);
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3d& v : own.vertices) bounds.extend(v);
  Json json{{"name", entry.name}, {"path", path}, {"size", Json()}};
  if (std::holds_alternative<BoxShape>(entry.body))
    json["size"] = numbers(bounds.sizes());
  json["R"] = rows(pose_of(entry.placement).R);
  json.update(mesh_json(transformed(own, pose_of(entry.placement))));
  return json;
}

/// Of drawn bodies none has a path of its own.
Json occluder_json(const OccluderEntry& entry, const std::string& path) {
  Json json = body_json(entry, path);
  json["carried"] = entry.mount == Mount::target;
  json["room"] = entry.room;
  return json;
}

Json surface_json(const SurfaceEntry& entry) {
  if (const auto* rail = std::get_if<RailSurface>(&entry.shape)) {
    Json line = Json::array();
    for (const Eigen::Vector3d& p : rail->points) line.push_back(numbers(p));
    return line;
  }
  const auto* patch = std::get_if<PatchSurface>(&entry.shape);
  if (!patch) return Json::array();
  const PatchSurface& s = *patch;
  Json line = Json::array();
  for (const Eigen::Vector3d& p : {s.origin, Eigen::Vector3d(s.origin + s.u),
                                   Eigen::Vector3d(s.origin + s.u + s.v),
                                   Eigen::Vector3d(s.origin + s.v), s.origin})
    line.push_back(numbers(p));
  return line;
}

}  // namespace

Eigen::AlignedBox3d sample_box(const Scene& scene) {
  if (const AdaptiveSampling* adaptive = adaptive_sampling(scene))
    return {adaptive->min, adaptive->max};
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : make_samples(scene.samples).points) box.extend(p);
  return box;
}

Eigen::AlignedBox3d room_box(const LoadedScene& loaded) {
  Eigen::AlignedBox3d box = sample_box(loaded.scene);
  for (const PlacedDevice& device : loaded.system.devices)
    if (!device.carried()) box.extend(device.X_WS().p);
  return box;
}

Json description(const Design& design, std::size_t revision, PluginRegistry& plugins) {
  Json json{{"revision", revision},
            {"undo", design.history().undoable()},
            {"redo", design.history().redoable()},
            {"surroundings", design.surroundings()}};
  json.update(description(design.loaded(), plugins));
  return json;
}

Json description(const LoadedScene& loaded, PluginRegistry& plugins) {
  const Eigen::AlignedBox3d samples = sample_box(loaded.scene), room = room_box(loaded);
  const double reach = samples.isEmpty() ? 1 : room.diagonal().norm();
  Outlines outlines(reach > 0 ? reach / 4 : 1);
  Json json{{"name", loaded.scene.name},
            {"metric",
             {{"name", loaded.metric.name},
              {"unit", loaded.metric.unit},
              {"larger_is_better", loaded.metric.larger_is_better}}},
            {"metrics", metric_names(known_metrics(loaded.scene))},
            {"definition", to_string(definition_of(loaded.system))},
            {"fusion", to_string(loaded.system.fusion)},
            {"box", {{"min", numbers(samples.min())}, {"max", numbers(samples.max())}}},
            {"room", {{"min", numbers(room.min())}, {"max", numbers(room.max())}}}};
  json["devices"] = Json::array();
  json["types"] = Json::object();
  for (std::size_t i = 0; i < loaded.scene.devices.size(); ++i) {
    const DeviceEntry& entry = loaded.scene.devices[i];
    json["devices"].push_back(device_json(entry, loaded.system.devices[i], outlines));
    if (!json["types"].contains(entry.type))
      json["types"][entry.type] = parameter_table(*plugins.find(entry.type).info);
  }
  return json;
}

Json surroundings(const Scene& scene) {
  Json json{{"occluders", Json::array()},
            {"regions", Json::array()},
            {"surfaces", Json::array()},
            {"beacons", Json::array()}};
  const std::vector<OccluderEntry> all = all_occluders(scene);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string& name = all[i].name;
    const bool drawn = i >= scene.occluders.size();
    json["occluders"].push_back(occluder_json(
        all[i], drawn ? "" : "occluders." + (name.empty() ? std::to_string(i) : name)));
  }
  for (const RegionEntry& entry : scene.regions)
    json["regions"].push_back(body_json(entry, "regions." + entry.name));
  for (const SurfaceEntry& entry : scene.surfaces)
    json["surfaces"].push_back(surface_json(entry));
  for (const BeaconSet& set : scene.beacons)
    for (const Beacon& beacon : lit_beacons(set))
      json["beacons"].push_back(numbers(beacon.p));
  return json;
}

}  // namespace delos::session
