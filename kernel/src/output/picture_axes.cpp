#include "output/picture_axes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "output/number_text.h"
#include "output/ticks.h"

namespace delos {
namespace {

constexpr Rgb kFrame{0.33, 0.33, 0.33};
const TextStyle kTickText{.size = 12, .colour = {0.2, 0.2, 0.2}};
const TextStyle kAxisText{.size = 13, .colour = {0.13, 0.13, 0.13}};

double widest(Canvas& canvas, const std::vector<Tick>& ticks) {
  double width = 0;
  for (const Tick& tick : ticks)
    width = std::max(width, canvas.text_width(tick.label, kTickText));
  return width;
}

/// As many ticks as fit side by side.
std::vector<Tick> ticks_across(Canvas& canvas, double low, double high, double length) {
  for (int wanted = static_cast<int>(length / 70);; --wanted) {
    std::vector<Tick> ticks = linear_ticks(low, high, wanted);
    const double room =
        length / static_cast<double>(std::max<std::size_t>(ticks.size(), 1));
    if (wanted <= 1 || widest(canvas, ticks) + 12 <= room) return ticks;
  }
}

std::string quantity_name(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

}  // namespace

void draw_axes(Canvas& canvas, const Box& plot, const Slice& slice) {
  canvas.outline({plot.x - 0.5, plot.y - 0.5, plot.width + 1, plot.height + 1}, kFrame);
  const SliceAxis& across = slice.axis[0];
  const SliceAxis& up = slice.axis[1];
  const bool small = std::max(across.span(), up.span()) < 0.2;
  const double factor = small ? 1000 : 1;
  const std::string unit = small ? "mm" : "m";

  const double x0 = factor * across.low(), dx = factor * across.span();
  for (const Tick& tick : ticks_across(canvas, x0, x0 + dx, plot.width)) {
    const double x = std::round(plot.x + plot.width * (tick.value - x0) / dx) + 0.5;
    canvas.line(x, plot.bottom() + 1, x, plot.bottom() + 5, kFrame);
    canvas.text(x, plot.bottom() + 20, 0.5, tick.label, kTickText);
  }
  canvas.text(plot.x + plot.width / 2, plot.bottom() + 42, 0.5,
              quantity_name(across.name, unit), kAxisText);

  const double y0 = factor * up.low(), dy = factor * up.span();
  const std::vector<Tick> rungs =
      linear_ticks(y0, y0 + dy, static_cast<int>(plot.height / 55));
  for (const Tick& tick : rungs) {
    const double y =
        std::round(plot.bottom() - plot.height * (tick.value - y0) / dy) - 0.5;
    canvas.line(plot.x - 5, y, plot.x - 1, y, kFrame);
    canvas.text(plot.x - 9, y + 4.5, 1, tick.label, kTickText);
  }
  canvas.text_upwards(plot.x - widest(canvas, rungs) - 22, plot.y + plot.height / 2,
                      quantity_name(up.name, unit), kAxisText);
}

void draw_colour_bar(Canvas& canvas, const Box& bar, const ColourScale& scale,
                     const std::string& metric, const std::string& si_unit,
                     const DisplayUnit& shown) {
  for (int i = 0; i < bar.height; ++i) {
    const double position = scale.flat() ? 0.5 : 1 - (i + 0.5) / bar.height;
    canvas.fill({bar.x, bar.y + i, bar.width, 1}, scale.colour(position));
  }
  canvas.outline({bar.x - 0.5, bar.y - 0.5, bar.width + 1, bar.height + 1}, kFrame);

  const int wanted = static_cast<int>(bar.height / 50);
  const bool log_labels = scale.log10 && !scale.flat();
  std::vector<Tick> ticks =
      log_labels
          ? log_ticks(scale.low, scale.high, wanted, si_unit)
          : linear_ticks(scale.low * shown.factor, scale.high * shown.factor, wanted);
  for (Tick& tick : ticks) {
    if (!log_labels) tick.value /= shown.factor;
    const double y = std::round(bar.bottom() - bar.height * scale.position(tick.value));
    const double at = std::clamp(y, bar.y, bar.bottom() - 1) + 0.5;
    canvas.line(bar.right() + 1, at, bar.right() + 4, at, kFrame);
    canvas.text(bar.right() + 8, at + 4, 0, tick.label, kTickText);
  }
  const std::string name = one_line(metric);
  const std::string label =
      log_labels ? name + ", log scale" : quantity_name(name, shown.name);
  canvas.text_upwards(bar.right() + widest(canvas, ticks) + 28, bar.y + bar.height / 2,
                      label + (scale.flat() ? "" : ", bright is better"), kAxisText);
}

}  // namespace delos
