// The inside of a picture's plot.
#pragma once

#include "output/canvas.h"
#include "output/shading.h"

namespace delos {

/// Fill the plot with the slice: colours where it is finite, hatching where it is
/// blind, plain light grey where a cancelled evaluation didn't get; a line around blind
/// regions.
void paint_cells(Canvas& canvas, const Box& plot, const Slice& slice,
                 const ColourScale& scale);

/// The hatching of blind regions in a box of its own, for the legend.
void paint_blind(Canvas& canvas, const Box& box);

/// The plain grey of what wasn't reached, likewise.
void paint_unreached(Canvas& canvas, const Box& box);
void paint_solid(Canvas& canvas, const Box& box);

}  // namespace delos
