// The best and the worst sample in a picture.
#pragma once

#include <string>

#include "output/canvas.h"
#include "output/slice.h"

namespace delos {

/// Mark both with their values, the labels inside the plot and clear of each other; one
/// mark where all values are equal; a sentence where nothing is finite.
/// @param cells what the slice fills of the plot
/// @param unit the metric's SI unit
void draw_markers(Canvas& canvas, const Box& plot, const Box& cells, const Slice& slice,
                  bool all_equal, const std::string& unit);

}  // namespace delos
