// What drawings in SVG need.
#pragma once

#include <string>

#include "figures/html.h"

namespace delos::figures {

/// A coordinate in tenths of a pixel, "12.5".
[[nodiscard]] std::string px(double value);

/// Text at a place. @param anchor "start", "middle" or "end"
[[nodiscard]] Html svg_text(double x, double y, const char* anchor, const Html& text,
                            double size = 13);
/// Text that reads upwards, centred.
[[nodiscard]] Html svg_text_upwards(double x, double y, const Html& text);
[[nodiscard]] Html svg_line(double x0, double y0, double x1, double y1,
                            const char* colour);

/// A drawing of width × height units that is read as one picture.
/// @param says the alternative text
[[nodiscard]] Html svg(double width, double height, const std::string& says,
                       const Html& content);

}  // namespace delos::figures
