#include "report/shown.h"

#include <set>

#include "output/base64.h"
#include "session/description.h"

namespace delos::report {

Shown shown(const session::LoadedScene& loaded, const Making& making) {
  session::Evaluation evaluation = session::evaluate_scene(loaded, making.options);
  making.between();
  Field field = evaluation.field;
  session::DrawnField drawn = session::drawn_of(loaded, std::move(evaluation));
  if (drawn.field.value.size() > kMostDrawn) {
    session::Json summary = std::move(drawn.summary);
    drawn = session::draw_field(loaded, kMostDrawn, making.options);
    drawn.summary = std::move(summary);
    making.between();
  }
  drawn.field.scene = loaded.scene.name;
  return {loaded, std::move(field), std::move(drawn)};
}

session::Json packed_json(session::DrawnField drawn) {
  for (const char* own : {"threads", "seconds"}) drawn.summary.erase(own);
  return base64_of(session::packed(drawn, 0));
}

session::Json design_json(const Shown& shown, PluginRegistry& plugins) {
  return {{"description", session::description(shown.loaded, plugins)},
          {"around", session::surroundings(shown.loaded.scene)},
          {"field", packed_json(shown.drawn)}};
}

session::Json versions_json(const Making& making, const std::string& begun_with,
                            const Scene& scene, PluginRegistry& plugins) {
  session::Json all = session::Json::array();
  const auto add = [&](const std::string& part, const std::string& version) {
    all.push_back({{"part", part}, {"version", version}});
  };
  add("delos", making.version);
  if (!begun_with.empty() && begun_with != making.version)
    add("delos, when the study began", begun_with);
  std::set<std::string> types;
  for (const DeviceEntry& device : scene.devices) types.insert(device.type);
  for (const std::string& type : types)
    add("device " + type, plugins.find(type).info->version);
  return all;
}

}  // namespace delos::report
