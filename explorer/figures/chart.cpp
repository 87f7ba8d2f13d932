#include "figures/chart.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

#include "delos/model/infinity.h"
#include "delos/text/format.h"
#include "figures/svg.h"
#include "output/ticks.h"

namespace delos::figures {
namespace {

constexpr double kWidth = 720, kHeight = 380;
constexpr double kLeft = 84, kRight = 16, kTop = 40, kBottom = 52;
constexpr const char* kColours[] = {"#2166ac", "#b2182b", "#1b7837", "#7b3294"};
constexpr const char* kGrid = "#dddddd";

/// From values to pixels.
struct Axes {
  double x0 = 0, x1 = 1, y0 = 0, y1 = 1;
  bool log = false;

  [[nodiscard]] double x(double value) const {
    return kLeft + (value - x0) / (x1 - x0) * (kWidth - kLeft - kRight);
  }
  [[nodiscard]] double y(double value) const {
    const double part =
        log ? std::log(value / y0) / std::log(y1 / y0) : (value - y0) / (y1 - y0);
    return kHeight - kBottom - part * (kHeight - kTop - kBottom);
  }
};

Axes axes_of(const Chart& chart) {
  Axes a{kInfinity, -kInfinity, kInfinity, -kInfinity, false};
  for (const Series& series : chart.series) {
    for (const auto& [x, y] : series.points) {
      a.x0 = std::min(a.x0, x);
      a.x1 = std::max(a.x1, x);
      a.y0 = std::min(a.y0, y);
      a.y1 = std::max(a.y1, y);
    }
  }
  a.log = a.y0 > 0 && a.y1 > 5 * a.y0;
  if (a.x1 == a.x0) a.x0 -= 0.5, a.x1 += 0.5;
  const double room = a.y1 > a.y0 ? 0.04 * (a.y1 - a.y0)
                      : a.y0 != 0 ? 0.1 * std::abs(a.y0)
                                  : 0.5;
  if (a.log) {
    a.y0 /= 1.1;
    a.y1 *= 1.1;
  } else {
    a.y0 -= room;
    a.y1 += room;
  }
  return a;
}

Html grid(const Chart& chart, const Axes& a) {
  Html out;
  const DisplayUnit unit =
      display_unit(std::max(std::abs(a.y0), std::abs(a.y1)), chart.y_unit);
  std::vector<Tick> ticks;
  if (a.log) {
    ticks = log_ticks(a.y0, a.y1, 6, chart.y_unit);
  } else {
    ticks = linear_ticks(a.y0 * unit.factor, a.y1 * unit.factor, 6);
    for (Tick& tick : ticks) tick.value /= unit.factor;
  }
  for (const Tick& tick : ticks) {
    const double y = a.y(tick.value);
    out += svg_line(kLeft, y, kWidth - kRight, y, kGrid);
    out += svg_text(kLeft - 6, y + 4, "end", tick.label);
  }
  const DisplayUnit along =
      display_unit(std::max(std::abs(a.x0), std::abs(a.x1)), chart.x_unit);
  for (const Tick& tick : linear_ticks(a.x0 * along.factor, a.x1 * along.factor, 7)) {
    const double x = a.x(tick.value / along.factor);
    out += svg_line(x, kHeight - kBottom, x, kHeight - kBottom + 5, "#555555");
    out += svg_text(x, kHeight - kBottom + 19, "middle", tick.label);
  }
  const auto named = [](const std::string& name, const std::string& unit_name) {
    return unit_name.empty() ? name : name + " [" + unit_name + "]";
  };
  out +=
      svg_line(kLeft, kHeight - kBottom, kWidth - kRight, kHeight - kBottom, "#555555");
  out += svg_text((kLeft + kWidth - kRight) / 2, kHeight - 10, "middle",
                  named(chart.x_name, along.name));
  out += svg_text_upwards(14, (kTop + kHeight - kBottom) / 2,
                          named(chart.y_name, a.log ? "" : unit.name));
  return out;
}

Html drawn(const Series& series, const Axes& a, const char* colour) {
  std::string path;
  Html discs;
  const auto add = [&](std::initializer_list<std::string_view> parts) {
    for (const std::string_view part : parts) path += part;
  };
  for (const auto& [x, y] : series.points) {
    const std::string px_x = px(a.x(x)), px_y = px(a.y(y));
    if (series.stroke == Stroke::dots)
      add({"M", px_x, " ", px_y, "h0"});
    else if (path.empty())
      add({"M", px_x, " ", px_y});
    else if (series.stroke == Stroke::steps)
      add({"H", px_x, "V", px_y});
    else
      add({"L", px_x, " ", px_y});
    if (series.stroke == Stroke::line)
      discs += element("circle",
                       {{"cx", px_x}, {"cy", px_y}, {"r", "4"}, {"fill", colour}}, {});
  }
  const bool dots = series.stroke == Stroke::dots;
  return element("path",
                 {{"d", path},
                  {"fill", "none"},
                  {"stroke", dots ? "#9a9a9a" : colour},
                  {"stroke-width", dots ? "3" : "2.2"},
                  {"stroke-linecap", "round"}},
                 {}) +
         discs;
}

/// Marks stand on lines of their own above the plot where they would overlap.
Html marked(const std::vector<ChartMark>& marks, const Axes& a) {
  Html out;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const double x = a.x(marks[i].x);
    out +=
        element("path",
                {{"d", "M" + px(x) + " " + px(kTop - 6) + "V" + px(kHeight - kBottom)},
                 {"stroke", "#b2182b"},
                 {"stroke-dasharray", "4 3"},
                 {"fill", "none"}},
                {});
    const bool right = x > kWidth / 2;
    out += svg_text(x + (right ? -4 : 4), kTop + 8 + 15 * static_cast<double>(i % 8),
                    right ? "end" : "start", marks[i].label, 12);
  }
  return out;
}

}  // namespace

Html chart_drawing(const Chart& chart) {
  const Axes a = axes_of(chart);
  Html content = grid(chart, a);
  double legend = kLeft;
  std::size_t lines = 0;
  for (const Series& series : chart.series) {
    const bool dots = series.stroke == Stroke::dots;
    const char* colour = dots ? "#9a9a9a" : kColours[lines++ % std::size(kColours)];
    content += drawn(series, a, colour);
    content += element("rect",
                       {{"x", px(legend)},
                        {"y", "10"},
                        {"width", "18"},
                        {"height", "5"},
                        {"fill", colour}},
                       {}) +
               svg_text(legend + 24, 17, "start", series.name);
    legend += 44 + 7.4 * static_cast<double>(series.name.size());
  }
  content += marked(chart.marks, a);
  return svg(kWidth, kHeight, chart.says, content);
}

Html chart_figure(const Chart& chart, const Html& caption) {
  return element("figure", chart_drawing(chart) + element("figcaption", caption));
}

}  // namespace delos::figures
