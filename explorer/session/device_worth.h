// What each device is worth to the whole room: what would be lost without it.
#pragma once

#include <string>
#include <vector>

#include "delos/field/evaluate.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

struct DeviceWorth {
  std::string name;
  /// Samples where the metric is finite, and wouldn't be without this device alone.
  std::size_t blinded = 0;
  /// Samples that wouldn't be observable any more.
  std::size_t lost = 0;
  /// Relative rise of the mean metric's loss without it, over the samples where it
  /// stays finite, as DeviceShare::share; NaN where there is none.
  double rise = 0;
};

/// Take away each device by itself and evaluate the samples anew.
/// @returns one a device, in the order of the scene; none of a scene with one device,
///          which is worth all, or where options.cancel stopped it
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] std::vector<DeviceWorth> device_worth(const LoadedScene& loaded,
                                                    const Samples& samples,
                                                    const FieldOptions& options);

/// {samples, devices: [{name, blinded, lost, rise}]}
[[nodiscard]] Json worth_json(const std::vector<DeviceWorth>& worth,
                              const Samples& samples);

}  // namespace delos::session
