// Where the parts of a picture go.
#pragma once

#include "output/canvas.h"
#include "output/slice.h"

namespace delos {

/// Whole pixels, so that edges are sharp.
struct PictureLayout {
  int width, height;  ///< of the image
  Box plot, bar;
  bool to_scale;  ///< one scale on both axes
};

/// A plot with the slice's proportions in an image of at most about 900×700; a slice
/// that is very long and thin is stretched until its marks can be read.
[[nodiscard]] PictureLayout lay_out_picture(const Slice& slice);

}  // namespace delos
