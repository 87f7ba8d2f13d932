// Published figures of devices that one can buy, as parameters of plugins.
#pragma once

#include <span>

namespace delos::session {

/// A device by name. What has no published figure isn't in it.
struct DevicePreset {
  const char* name;    ///< "ADIS16448"
  const char* type;    ///< the plugin
  const char* params;  ///< as a scene writes them, without braces
  const char* add;     ///< parameters that you have to know; may be empty
  const char* source;  ///< where the figures were read, and what they are of
};

/// In the order of the plugins.
[[nodiscard]] std::span<const DevicePreset> device_presets();

}  // namespace delos::session
