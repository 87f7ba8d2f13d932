// The scales around a picture's plot.
#pragma once

#include <string>

#include "delos/output/format.h"
#include "output/canvas.h"
#include "output/shading.h"
#include "output/slice.h"

namespace delos {

/// The frame of the plot, with positions in metres; millimetres on small slices.
void draw_axes(Canvas& canvas, const Box& plot, const Slice& slice);

/// The colours with the values that they stand for.
/// @param si_unit the metric's; @param shown in which a linear scale's labels are
void draw_colour_bar(Canvas& canvas, const Box& bar, const ColourScale& scale,
                     const std::string& metric, const std::string& si_unit,
                     const DisplayUnit& shown);

}  // namespace delos
