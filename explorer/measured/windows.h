// Scattered places as a surface: what a tracker does where.
#pragma once

#include "delos/field/field.h"
#include "delos/geometry/scattered.h"
#include "measured/comparison.h"

namespace delos::measured {

/// Some neighbouring places of a path taken together.
struct Window {
  Eigen::Vector3d p;  ///< their middle
  double measured;    ///< root mean square, metres
  double predicted;   ///< likewise of P∞'s; +∞ where one has none
};

/// @param size places a window, ≥ 1; what is left at a path's end joins the last
[[nodiscard]] std::vector<Window> windows_of(const PosesComparison& comparison,
                                             std::size_t size);

/// What of a window a surface goes through.
enum class WindowValue {
  measured,
  predicted,
  ratio,  ///< measured over predicted; +∞ where that isn't finite
};

/// One a window, as a field over scattered samples.
[[nodiscard]] Field window_field(const std::vector<Window>& windows, WindowValue what,
                                 const std::string& scene);

/// The surface through windows, on a level grid of about 60 by 60 places at their mean
/// height. +∞ where it is blind, and where the interpolation says nothing.
/// @throws std::invalid_argument as ScatteredSurface; all windows in one line
[[nodiscard]] Field measured_surface(const std::vector<Window>& windows,
                                     WindowValue what, const ScatteredOptions& how,
                                     const std::string& scene);

}  // namespace delos::measured
