#include "imports/opening.h"

#include <cmath>

#include "delos/device/camera_model.h"
#include "delos/text/format.h"

namespace delos::imports {

std::string opening_text(const PlacedDevice& device) {
  if (device.type != "camera") return device.type;
  const CameraModel lens(device.params);
  const auto angle = [](double pixels, double f) {
    return format_quantity(2 * std::atan(pixels / 2 / f), "rad");
  };
  if (lens.fisheye()) return "fisheye";
  return angle(lens.width(), lens.f_across()) + " x " +
         angle(lens.height(), lens.f_down());
}

}  // namespace delos::imports
