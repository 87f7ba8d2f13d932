#include "delos/scene/presets.h"

#include <algorithm>

namespace delos {

std::span<const DevicePreset> device_presets() {
  static constexpr DevicePreset kPresets[] = {
#include DELOS_PRESETS  // plugins/presets.inc: the kernel itself names no device
  };
  return kPresets;
}

const DevicePreset* device_preset(const std::string& name) {
  const auto all = device_presets();
  const auto found = std::find_if(all.begin(), all.end(), [&](const DevicePreset& one) {
    return one.name == name;
  });
  return found == all.end() ? nullptr : &*found;
}

std::vector<std::string> preset_sources(const Scene& scene) {
  std::vector<std::string> lines;
  for (const DevicePreset& one : device_presets()) {
    const bool used = std::any_of(
        scene.devices.begin(), scene.devices.end(),
        [&](const DeviceEntry& device) { return device.preset == one.name; });
    if (used) lines.push_back(std::string(one.name) + ": " + one.source);
  }
  return lines;
}

}  // namespace delos
