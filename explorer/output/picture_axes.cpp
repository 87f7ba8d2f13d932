#include "output/picture_axes.h"

#include <algorithm>
#include <cmath>

#include "delos/text/number_text.h"

namespace delos {
namespace {

constexpr Rgb kFrame{0.33, 0.33, 0.33};
const TextStyle kTickText{.size = 12, .colour = {0.2, 0.2, 0.2}};
const TextStyle kAxisText{.size = 13, .colour = {0.13, 0.13, 0.13}};

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

/// The frame just outside of a box of whole pixels.
void draw_frame(Canvas& canvas, const Box& box) {
  canvas.outline({box.x - 0.5, box.y - 0.5, box.width + 1, box.height + 1}, kFrame);
}

}  // namespace

ScaleText axis_text(Canvas& canvas, const Slice& slice, const PictureFrame& frame,
                    int side, double pixels) {
  const bool small = std::max(frame.side[0].span, frame.side[1].span) < 0.2;
  const double factor = small ? 1000 : 1;
  const SliceAxis& axis = slice.axis[side];
  ScaleText text;
  text.name = with_unit(axis.name, small ? "mm" : "m");

  // The cell of a single sample is no range to measure in.
  const FrameSide& shown = frame.side[side];
  const bool range = axis.count > 1 || shown.span > axis.span();
  const double low = factor * (range ? shown.low : axis.first);
  const double high = factor * (range ? shown.low + shown.span : axis.first);
  for (int wanted = static_cast<int>(pixels / (side == 0 ? 70 : 55));; --wanted) {
    text.ticks = linear_ticks(low, high, wanted);
    // Side by side, numbers need their widths; one above the other, they always fit.
    const double room = pixels / static_cast<double>(text.ticks.size() + 1);
    if (side == 1 || wanted <= 1 || widest(canvas, text) + 10 <= room) break;
  }
  for (Tick& tick : text.ticks) tick.value /= factor;
  return text;
}

ScaleText bar_text(const ColourScale& scale, const std::string& metric,
                   const std::string& unit, const DisplayUnit& shown, double pixels) {
  int wanted = static_cast<int>(pixels / 45);
  if (scale.counts)
    wanted = static_cast<int>(std::min<double>(wanted, scale.high - scale.low));
  const std::string name = one_line(metric);
  if (scale.log10 && !scale.flat())
    return {log_ticks(scale.low, scale.high, wanted, unit), name + ", log scale"};

  ScaleText text{
      linear_ticks(scale.low * shown.factor, scale.high * shown.factor, wanted),
      with_unit(name, shown.name)};
  for (Tick& tick : text.ticks) tick.value /= shown.factor;
  return text;
}

double widest(Canvas& canvas, const ScaleText& text) {
  double width = 0;
  for (const Tick& tick : text.ticks)
    width = std::max(width, canvas.text_width(tick.label, kTickText));
  return width;
}

void draw_axes(Canvas& canvas, const Box& plot, const PictureFrame& frame,
               const ScaleText& across, const ScaleText& up) {
  draw_frame(canvas, plot);
  for (const Tick& tick : across.ticks) {
    const double fraction = frame.side[0].fraction_of(tick.value);
    const double x = std::round(plot.x + plot.width * fraction) + 0.5;
    canvas.line(x, plot.bottom() + 1, x, plot.bottom() + 5, kFrame);
    canvas.text(x, plot.bottom() + 20, 0.5, tick.label, kTickText);
  }
  canvas.text(plot.x + plot.width / 2, plot.bottom() + 42, 0.5, across.name, kAxisText);

  for (const Tick& tick : up.ticks) {
    const double fraction = frame.side[1].fraction_of(tick.value);
    const double y = std::round(plot.bottom() - plot.height * fraction) - 0.5;
    canvas.line(plot.x - 5, y, plot.x - 1, y, kFrame);
    canvas.text(plot.x - 9, y + 4.5, 1, tick.label, kTickText);
  }
  canvas.text_upwards(plot.x - widest(canvas, up) - 22, plot.y + plot.height / 2,
                      up.name, kAxisText);
}

void draw_colour_bar(Canvas& canvas, const Box& bar, const ColourScale& scale,
                     const ScaleText& text) {
  for (int i = 0; i < bar.height; ++i) {
    const double position = scale.flat() ? 0.5 : 1 - (i + 0.5) / bar.height;
    canvas.fill({bar.x, bar.y + i, bar.width, 1}, scale.colour(position));
  }
  draw_frame(canvas, bar);
  for (const Tick& tick : text.ticks) {
    const double y = std::round(bar.bottom() - bar.height * scale.position(tick.value));
    const double at = std::clamp(y, bar.y, bar.bottom() - 1) + 0.5;
    canvas.line(bar.right() + 1, at, bar.right() + 4, at, kFrame);
    canvas.text(bar.right() + 8, at + 4, 0, tick.label, kTickText);
  }
  if (scale.change && !scale.flat()) {
    const double y = std::round(bar.bottom() - bar.height * scale.position(0)) + 0.5;
    canvas.line(bar.x, y, bar.right(), y, kFrame, 2);
  }
  const std::string full =
      text.name + (scale.change ? ", blue is better" : ", bright is better");
  const bool told = !scale.flat() && canvas.text_width(full, kAxisText) <= bar.height;
  canvas.text_upwards(bar.right() + widest(canvas, text) + 28, bar.y + bar.height / 2,
                      told ? full : text.name, kAxisText);
}

}  // namespace delos
