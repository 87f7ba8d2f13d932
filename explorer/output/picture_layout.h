// Where the parts of a picture go.
#pragma once

#include "output/canvas.h"
#include "output/picture_frame.h"
#include "output/slice.h"

namespace delos {

/// Whole pixels, so that edges are sharp.
struct PictureLayout {
  int width, height;  ///< of the image
  Box plot, bar;
  Box cells;      ///< what the slice fills of the plot
  bool to_scale;  ///< the same scale on both axes, or one of them is a single sample
};

/// Room for text beside the plot, pixels.
struct SideText {
  double left;   ///< the vertical axis: numbers and name
  double right;  ///< the colour bar's; 0: there is no bar
};

/// A plot with the slice's proportions in an image of at most about 900×700; a slice
/// that is very long and thin is stretched until its marks can be read.
[[nodiscard]] PictureLayout lay_out_picture(const Slice& slice,
                                            const PictureFrame& frame,
                                            const SideText& text);

}  // namespace delos
