// What is written on a picture: its title, what its colours mean, names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/room_layer.h"

namespace delos::render {

/// How wide the legend at the right is, pixels.
inline constexpr int kLegend = 132;

struct LegendText {
  std::string title;  ///< the scene's name
  std::string metric, unit;
  std::size_t blind = 0, samples = 0;  ///< of those outside solids
};

/// Write on a picture.
/// @param colours nullopt: no sample has a value
/// @param marks of values on the bar
void draw_legend(Picture& picture, const Ground& ground, const LegendText& text,
                 const std::optional<ColourRange>& colours,
                 const std::vector<double>& marks, const std::vector<Label>& labels);

}  // namespace delos::render
