// The scales around a picture's plot.
#pragma once

#include <string>
#include <vector>

#include "delos/text/format.h"
#include "output/canvas.h"
#include "output/picture_frame.h"
#include "output/shading.h"
#include "output/slice.h"
#include "output/ticks.h"

namespace delos {

/// What stands beside a scale: numbers in some unit, and what they are numbers of.
struct ScaleText {
  std::vector<Tick> ticks;  ///< values in SI
  std::string name;         ///< "x [m]"
};

/// Positions along an axis, in metres; in millimetres where the slice is small.
/// @param pixels length of the axis
[[nodiscard]] ScaleText axis_text(Canvas& canvas, const Slice& slice,
                                  const PictureFrame& frame, int side, double pixels);

/// Values along a colour bar.
/// @param unit the metric's SI unit; @param shown the unit of a linear scale's numbers
[[nodiscard]] ScaleText bar_text(const ColourScale& scale, const std::string& metric,
                                 const std::string& unit, const DisplayUnit& shown,
                                 double pixels);

/// Width of the widest number, pixels.
[[nodiscard]] double widest(Canvas& canvas, const ScaleText& text);

/// The plot's frame with its two axes.
void draw_axes(Canvas& canvas, const Box& plot, const PictureFrame& frame,
               const ScaleText& across, const ScaleText& up);

/// The colours with the values that they stand for.
void draw_colour_bar(Canvas& canvas, const Box& bar, const ColourScale& scale,
                     const ScaleText& text);

}  // namespace delos
