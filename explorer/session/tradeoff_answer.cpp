#include "session/tradeoff_answer.h"

#include <algorithm>

#include "delos/scene/definition.h"
#include "session/search_answer.h"

namespace delos::session {
namespace {

/// @param found a scene of the points; all have one definition
Json header(const Scene& scene, const Scene& found) {
  return {
      {"scene", scene.name},
      {"objective", {{"name", objective_text(scene)}, {"unit", objective_unit(scene)}}},
      {"fusion", to_string(definition_of(found).fusion)},
      {"covariance", to_string(found.covariance)}};
}

Json point_json(const DeviceCountPoint& point, const Scene& scene,
                PluginRegistry& plugins) {
  Json names = Json::array();
  for (const DeviceEntry& device : point.scene.devices) names.push_back(device.name);
  return {{"devices", point.devices},
          {"price", number(point.price)},
          {"objective", number(objective_shown(scene, point.objective))},
          {"kept", point.kept},
          {"constraints", constraints_json(point.constraints)},
          {"names", names},
          {"variables", variables_json(point.scene, plugins)}};
}

}  // namespace

std::string limit_unit(const Scene& scene, const std::string& constraint) {
  const auto entry =
      std::find_if(scene.constraints.begin(), scene.constraints.end(),
                   [&](const ConstraintEntry& e) { return e.name == constraint; });
  return constraint_unit(*entry, scene);
}

Json front_json(const Scene& scene, const std::string& constraint,
                const std::vector<FrontPoint>& points, PluginRegistry& plugins) {
  Json json = header(scene, points.front().scene);
  json["limit"] = {{"constraint", constraint}, {"unit", limit_unit(scene, constraint)}};
  json["points"] = Json::array();
  for (const FrontPoint& point : points)
    json["points"].push_back(
        {{"limit", number(point.limit)},
         {"used", number(point.used)},
         {"objective", number(objective_shown(scene, point.objective))},
         {"kept", point.kept},
         {"dominated", point.dominated},
         {"variables", variables_json(point.scene, plugins)}});
  return json;
}

Json counts_json(const Scene& scene, const std::vector<DeviceCountPoint>& points,
                 PluginRegistry& plugins) {
  const auto reached = std::find_if(
      points.begin(), points.end(),
      [](const DeviceCountPoint& point) { return !point.scene.devices.empty(); });
  Json json = header(scene, reached == points.end() ? scene : reached->scene);
  json["points"] = Json::array();
  for (const DeviceCountPoint& point : points)
    json["points"].push_back(point_json(point, scene, plugins));
  const DeviceCountPoint* cheapest = cheapest_kept(points);
  json["cheapest"] =
      cheapest
          ? Json({{"devices", cheapest->devices}, {"price", number(cheapest->price)}})
          : Json();
  return json;
}

}  // namespace delos::session
