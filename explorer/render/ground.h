// Colours of what isn't a value, on a dark ground and on a light one.
#pragma once

#include "render/raster.h"

namespace delos::render {

struct Ground {
  Colour background, text, lines, faint, bodies, beacons, device, sight;
  Colour blind, blind_between;  ///< stripes of the hatch
  Colour solid;
};

inline constexpr Ground kLight{
    {1, 1, 1},          {0.13, 0.13, 0.16}, {0.42, 0.45, 0.53}, {0.85, 0.86, 0.89},
    {0.66, 0.69, 0.74}, {0.71, 0.37, 0},    {0.29, 0.33, 0.41}, {0.46, 0.50, 0.60},
    {0.64, 0.67, 0.72}, {0.87, 0.89, 0.92}, {0.40, 0.40, 0.40}};
inline constexpr Ground kDark{
    {0.08, 0.09, 0.12}, {0.91, 0.93, 0.96}, {0.53, 0.57, 0.65}, {0.17, 0.19, 0.24},
    {0.55, 0.60, 0.70}, {1, 0.71, 0.33},    {0.84, 0.86, 0.91}, {0.66, 0.71, 0.79},
    {0.42, 0.44, 0.50}, {0.20, 0.23, 0.28}, {0.02, 0.02, 0.03}};

/// The stripe of a hatch at a pixel.
[[nodiscard]] inline const Colour& hatch(const Ground& ground, int x, int y) {
  constexpr int kPeriod = 12, kStripe = 5;  // pixels
  return (x + y) % kPeriod < kStripe ? ground.blind : ground.blind_between;
}

}  // namespace delos::render
