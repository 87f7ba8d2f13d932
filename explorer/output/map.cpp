#include "output/map.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "output/base64.h"
#include "output/canvas.h"
#include "output/picture_cells.h"
#include "output/shading.h"
#include "output/slice.h"

namespace delos {
namespace {

constexpr double kLongerSide = 400;  // pixels
constexpr double kLeast = 40;        // pixels, of a slice that is long and thin

ColourScale scale_of(const ColourRange& colours) {
  ColourScale scale;
  scale.low = colours.low;
  scale.high = colours.high;
  scale.log10 = colours.log10;
  scale.bright_high = colours.larger_is_better;
  scale.change = colours.change;
  return scale;
}

std::string data_uri(const Canvas& canvas) {
  std::ostringstream png, uri;
  canvas.write_png(png);
  uri << "data:image/png;base64,";
  Base64Stream base64(uri);
  for (const char byte : png.str()) base64.add(static_cast<unsigned char>(byte));
  base64.finish();
  return uri.str();
}

MapSide side_of(const SliceAxis& axis) {
  return {axis.name, axis.low(), axis.low() + axis.span()};
}

}  // namespace

std::optional<FieldMap> field_map(const Field& field, const PictureOptions& options,
                                  const ColourRange& colours) {
  if (!has_slice(field.samples)) return std::nullopt;
  const Slice slice = make_slice(field, options);
  FieldMap map{
      slice.place, side_of(slice.axis[0]), side_of(slice.axis[1]), {}, 0, 0, 0};
  map.samples = slice.value.size();
  for (std::size_t i = 0; i < slice.value.size(); ++i) {
    if (slice.solid[i] != 0)
      ++map.solid;
    else if (!std::isfinite(slice.value[i]))
      ++map.blind;
  }
  const double width = slice.axis[0].span(), height = slice.axis[1].span();
  const double scale = kLongerSide / std::max(width, height);
  const auto pixels = [&](double length) {
    return static_cast<int>(std::lround(std::max(length * scale, kLeast)));
  };
  Canvas canvas(pixels(width), pixels(height));
  paint_cells(
      canvas,
      {0, 0, static_cast<double>(canvas.width()), static_cast<double>(canvas.height())},
      slice, scale_of(colours));
  map.image = data_uri(canvas);
  return map;
}

std::string colour_strip(const ColourRange& colours) {
  const ColourScale scale = scale_of(colours);
  Canvas canvas(256, 8);
  for (int x = 0; x < canvas.width(); ++x)
    for (int y = 0; y < canvas.height(); ++y)
      canvas.set(x, y, scale.colour((x + 0.5) / canvas.width()));
  return data_uri(canvas);
}

double colour_position(const ColourRange& colours, double value) {
  return scale_of(colours).position(value);
}

std::array<double, 3> colour_of(const ColourRange& colours, double value) {
  const ColourScale scale = scale_of(colours);
  const Rgb colour = scale.colour(scale.position(value));
  return {colour.r, colour.g, colour.b};
}

}  // namespace delos
