// How much the metric changes with one number of the scene, everywhere.
#pragma once

#include <string>

#include "session/drawn_field.h"

namespace delos::session {

/// A field of slopes ∂(metric)/∂(number), and of which number.
struct Sensitivity {
  DrawnField drawn;            ///< its values are slopes, in its field's unit
  double value = 0;            ///< of the number, SI
  std::string unit;            ///< of the number, SI
  double least = 0, most = 0;  ///< between which the slope is taken
};

/// Slopes by central differences over 1e-5 of the number, or of 1 m or 1 rad
/// where that is more: of any number of any device, and with the hard edges of what is
/// seen. At a bound, to one side only. Where the metric jumps within the step, as a
/// device begins to see, there is no slope, and it is Drawn::blind; where the metric is
/// finite at one end alone it is Drawn::gained, if at the larger number, or
/// Drawn::lost.
///
/// Bends of less than 1e-9 of the value aren't told from rounding: beside them slopes
/// are right to 1e-4 of value over number.
///
/// The summary is that of drawn_change() with {sensitivity: {path, value, unit,
/// edges}}, the last how many samples jump.
/// @param path as find_number()
/// @param most as draw_field()
/// @throws Refusal that there is no such number
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] Sensitivity draw_sensitivity(const LoadedScene& loaded,
                                           const std::string& path, std::size_t most,
                                           const FieldOptions& options,
                                           PluginRegistry& plugins);

}  // namespace delos::session
