#include "output/colour_range.h"

#include "output/shading.h"

namespace delos {
namespace {

ColourScale scale_of(const ColourRange& colours) {
  ColourScale scale;
  scale.low = colours.low;
  scale.high = colours.high;
  scale.log10 = colours.log10;
  scale.bright_high = colours.larger_is_better;
  scale.change = colours.change;
  return scale;
}

}  // namespace

double colour_position(const ColourRange& colours, double value) {
  return scale_of(colours).position(value);
}

std::array<double, 3> colour_of(const ColourRange& colours, double value) {
  const ColourScale scale = scale_of(colours);
  const Rgb colour = scale.colour(scale.position(value));
  return {colour.r, colour.g, colour.b};
}

}  // namespace delos
