// The field in a picture: layers of grids, planes, surfaces, points, and shapes.
#pragma once

#include "output/colour_range.h"
#include "render/ground.h"
#include "render/picture.h"

namespace delos::render {

/// What everything is drawn with.
struct Pen {
  Raster& raster;
  const Eye& eye;  ///< of the raster's own frame
  const Ground& ground;
};

/// @param colours of values; nullopt: none has one
/// @throws session::Refusal as render_picture()
[[nodiscard]] std::vector<DrawnShape> draw_field_layer(
    const Pen& pen, const session::DrawnField& drawn,
    const std::optional<ColourRange>& colours, const PictureOptions& options);

/// A surface through scattered samples, and the samples, ringed, where they are few.
/// @param through as session::surface_through()
void draw_through(const Pen& pen, const session::DrawnField& through,
                  const std::optional<ColourRange>& colours);

}  // namespace delos::render
