#include "figures/svg.h"

#include <charconv>
#include <cmath>

namespace delos::figures {

std::string px(double value) {
  char buffer[32];
  const double rounded = std::round(value * 10) / 10;
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, rounded == 0 ? 0.0 : rounded,
                    std::chars_format::fixed);
  return {buffer, end.ptr};
}

Html svg_text(double x, double y, const char* anchor, const Html& text, double size) {
  return element(
      "text",
      {{"x", px(x)}, {"y", px(y)}, {"text-anchor", anchor}, {"font-size", px(size)}},
      text);
}

Html svg_text_upwards(double x, double y, const Html& text) {
  const std::string turn = "rotate(-90 " + px(x) + " " + px(y) + ")";
  return element("text",
                 {{"x", px(x)},
                  {"y", px(y)},
                  {"text-anchor", "middle"},
                  {"font-size", "13"},
                  {"transform", turn}},
                 text);
}

Html svg_line(double x0, double y0, double x1, double y1, const char* colour) {
  return element("line",
                 {{"x1", px(x0)},
                  {"y1", px(y0)},
                  {"x2", px(x1)},
                  {"y2", px(y1)},
                  {"stroke", colour}},
                 {});
}

Html svg(double width, double height, const std::string& says, const Html& content) {
  return element("svg",
                 {{"xmlns", "http://www.w3.org/2000/svg"},
                  {"viewBox", "0 0 " + px(width) + " " + px(height)},
                  {"role", "img"},
                  {"aria-label", says},
                  {"fill", "#1c1c1c"},
                  {"font-family", "system-ui, 'DejaVu Sans', sans-serif"}},
                 element("title", says) + content);
}

}  // namespace delos::figures
