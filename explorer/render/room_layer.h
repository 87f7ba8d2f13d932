// What stands in the room: its floor, bodies that hide, beacons, devices and what they
// see.
#pragma once

#include "render/field_layer.h"

namespace delos::render {

/// A word beside a point of the picture.
struct Label {
  Spot spot;  ///< pixels of the shown picture
  std::string text;
};

/// @returns the names of the devices
[[nodiscard]] std::vector<Label> draw_room_layer(const Pen& pen,
                                                 const session::LoadedScene& loaded,
                                                 const PictureOptions& options);

}  // namespace delos::render
