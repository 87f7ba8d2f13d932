// Maps of fields with their devices.
#pragma once

#include <string>
#include <vector>

#include "delos/field/field.h"
#include "output/map.h"
#include "output/marker.h"
#include "report/html.h"

namespace delos::report {

/// A map, its axes, and the markers that are near it.
/// @param around what the drawing has room for besides; maps side by side have the same
[[nodiscard]] Html map_figure(const FieldMap& map, const std::vector<Marker>& markers,
                              const std::vector<Marker>& around,
                              const std::string& says, const Html& caption);

/// The colours that maps share, with numbers, and what hatching means.
/// @param unit the metric's SI unit
[[nodiscard]] Html colour_legend(const ColourRange& colours, const std::string& name,
                                 const std::string& unit);

}  // namespace delos::report
