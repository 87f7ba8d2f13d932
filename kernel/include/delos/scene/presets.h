// Published figures of devices that one can buy, as parameters of plugins.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/scene/scene.h"

namespace delos {

/// A device by name. What has no published figure isn't in it.
struct DevicePreset {
  const char* name;    ///< "ADIS16448"
  const char* type;    ///< the plugin
  const char* params;  ///< as a scene writes them, without braces
  const char* add;     ///< parameters that you have to know; may be empty
  const char* source;  ///< where the figures were read, and what they are of
};

/// In the order of the plugins.
[[nodiscard]] DELOS_API std::span<const DevicePreset> device_presets();

/// The one of a name; null where there is none.
[[nodiscard]] DELOS_API const DevicePreset* device_preset(const std::string& name);

/// Of each preset that devices of a scene have, a line: its name and its source.
[[nodiscard]] DELOS_API std::vector<std::string> preset_sources(const Scene& scene);

}  // namespace delos
