#include "session/palette.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "delos/scene/presets.h"
#include "session/parameter_shape.h"
#include "session/shipped_scenes.h"

namespace delos::session {
namespace {

/// The first map of a plugin's examples, a line each: "- {sigma: 0.02}".
std::string first_example(const std::string& id) {
  constexpr std::string_view kItem = "- {";
  try {
    std::ifstream in(this_installation().shared("plugins", "plugins") / id /
                     "example.yaml");
    for (std::string line; std::getline(in, line);)
      if (line.rfind(kItem, 0) == 0) return line.substr(kItem.size() - 1);
  } catch (const std::runtime_error&) {
    // Of an installation without examples.
  }
  return "";
}

}  // namespace

std::string first_params(const PluginInfo& info) {
  const std::span<const ParamSpec> table(info.params, info.n_params);
  if (std::all_of(table.begin(), table.end(), has_default)) return "{}";
  const std::string example = first_example(info.id);
  if (!example.empty()) return example;
  for (const DevicePreset& preset : device_presets())
    if (preset.type == std::string_view(info.id))
      return preset_params(info.id, preset.name);
  return "";
}

std::string preset_params(const std::string& type, const std::string& preset) {
  for (const DevicePreset& p : device_presets())
    if (p.type == type && p.name == preset)
      return std::string("{") + p.params + (*p.add ? ", " : "") + p.add + "}";
  return "";
}

Json palette_json(PluginRegistry& plugins) {
  Json json{{"types", Json::array()}, {"presets", Json::array()}};
  for (const PluginLoad& load : plugins.all()) {
    if (!load.info) continue;
    json["types"].push_back({{"id", load.info->id},
                             {"summary", load.info->summary},
                             {"ready", !first_params(*load.info).empty()}});
  }
  for (const DevicePreset& p : device_presets())
    json["presets"].push_back(
        {{"name", p.name}, {"type", p.type}, {"source", p.source}});
  return json;
}

}  // namespace delos::session
