#include "report/map_figure.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "delos/text/format.h"
#include "output/ticks.h"
#include "report/svg.h"

namespace delos::report {
namespace {

constexpr double kMapWidth = 460, kMost = 420;  // of the drawing, and of its height
constexpr double kMapLeft = 46, kMapRight = 12, kMapTop = 12, kMapBottom = 44;

/// The world axis of a map's side; nullopt along a tilted edge.
std::optional<int> axis_of(const MapSide& side) {
  const std::string names = "xyz";
  const std::size_t at = side.name.size() == 1 ? names.find(side.name[0]) : names.npos;
  return at == names.npos ? std::nullopt : std::optional(static_cast<int>(at));
}

/// What the drawing shows, metres, to one scale.
struct Frame {
  double x0, x1, y0, y1, scale;

  [[nodiscard]] double x(double metres) const {
    return kMapLeft + (metres - x0) * scale;
  }
  [[nodiscard]] double y(double metres) const {
    return kMapTop + (y1 - metres) * scale;
  }
  [[nodiscard]] bool holds(double at_x, double at_y) const {
    return at_x >= x0 && at_x <= x1 && at_y >= y0 && at_y <= y1;
  }
  [[nodiscard]] double height() const {
    return kMapTop + (y1 - y0) * scale + kMapBottom;
  }
};

/// The map, and the devices that are no farther from it than it is large.
Frame frame_of(const FieldMap& map, const std::vector<Marker>& markers) {
  Frame f{map.across.low, map.across.high, map.up.low, map.up.high, 1};
  const double reach = std::max(f.x1 - f.x0, f.y1 - f.y0);
  const auto across = axis_of(map.across), up = axis_of(map.up);
  if (across && up) {
    const Frame own = f;
    for (const Marker& m : markers) {
      const double x = m.p[*across], y = m.p[*up];
      if (x < own.x0 - reach || x > own.x1 + reach || y < own.y0 - reach ||
          y > own.y1 + reach)
        continue;
      f = {std::min(f.x0, x), std::max(f.x1, x), std::min(f.y0, y), std::max(f.y1, y),
           1};
    }
  }
  const double border = 0.04 * std::max(f.x1 - f.x0, f.y1 - f.y0);
  f = {f.x0 - border, f.x1 + border, f.y0 - border, f.y1 + border, 1};
  f.scale = std::min((kMapWidth - kMapLeft - kMapRight) / (f.x1 - f.x0),
                     (kMost - kMapTop - kMapBottom) / (f.y1 - f.y0));
  return f;
}

Html axes(const FieldMap& map, const Frame& f) {
  Html out;
  const double bottom = f.y(f.y0), right = f.x(f.x1);
  for (const Tick& tick : linear_ticks(f.x0, f.x1, 6)) {
    const double x = f.x(tick.value);
    out += svg_line(x, bottom, x, bottom + 4, "#555555");
    out += svg_text(x, bottom + 17, "middle", tick.label);
  }
  for (const Tick& tick : linear_ticks(f.y0, f.y1, 5)) {
    const double y = f.y(tick.value);
    out += svg_line(kMapLeft - 4, y, kMapLeft, y, "#555555");
    out += svg_text(kMapLeft - 6, y + 4, "end", tick.label);
  }
  out += element("rect",
                 {{"x", px(kMapLeft)},
                  {"y", px(kMapTop)},
                  {"width", px(right - kMapLeft)},
                  {"height", px(bottom - kMapTop)},
                  {"fill", "none"},
                  {"stroke", "#555555"}},
                 {});
  out +=
      svg_text((kMapLeft + right) / 2, bottom + 36, "middle", map.across.name + " [m]");
  out += svg_text_upwards(14, (kMapTop + bottom) / 2, map.up.name + " [m]");
  return out;
}

Html marker(const Marker& m, const Frame& f, int across, int up, bool named) {
  const double x = f.x(m.p[across]), y = f.y(m.p[up]);
  Html out;
  if (m.faces) {
    const Eigen::Vector2d way((*m.faces)[across], -(*m.faces)[up]);
    constexpr double kLength = 22;
    out += element("line",
                   {{"x1", px(x)},
                    {"y1", px(y)},
                    {"x2", px(x + kLength * way.x())},
                    {"y2", px(y + kLength * way.y())},
                    {"stroke", "#b2182b"},
                    {"stroke-width", "2.5"}},
                   {});
  }
  out += element("circle",
                 {{"cx", px(x)},
                  {"cy", px(y)},
                  {"r", "4.5"},
                  {"fill", "#b2182b"},
                  {"stroke", "#ffffff"}},
                 element("title", m.name));
  if (!named) return out;
  const bool right = x > kMapWidth / 2;
  return out +
         element(
             "g",
             {{"paint-order", "stroke"}, {"stroke", "#ffffff"}, {"stroke-width", "3"}},
             svg_text(x + (right ? -8 : 8), y < kMapTop + 20 ? y + 14 : y - 6,
                      right ? "end" : "start", m.name, 12));
}

}  // namespace

Html map_figure(const FieldMap& map, const std::vector<Marker>& markers,
                const std::vector<Marker>& around, const std::string& says,
                const Html& caption) {
  const Frame f = frame_of(map, around);
  Html content = element("image",
                         {{"x", px(f.x(map.across.low))},
                          {"y", px(f.y(map.up.high))},
                          {"width", px((map.across.high - map.across.low) * f.scale)},
                          {"height", px((map.up.high - map.up.low) * f.scale)},
                          {"preserveAspectRatio", "none"},
                          {"href", map.image}},
                         {}) +
                 axes(map, f);
  const auto across = axis_of(map.across), up = axis_of(map.up);
  constexpr std::size_t kNamed = 12;  // names of more would cover each other
  for (const Marker& m : markers)
    if (across && up && f.holds(m.p[*across], m.p[*up]))
      content += marker(m, f, *across, *up, markers.size() <= kNamed);
  return element("figure", svg(kMapWidth, f.height(), says, content) +
                               element("figcaption", caption));
}

Html colour_legend(const ColourRange& colours, const std::string& name,
                   const std::string& unit) {
  constexpr double kLong = 420, kStart = 20;
  const DisplayUnit shown =
      display_unit(std::max(std::abs(colours.low), std::abs(colours.high)), unit);
  std::vector<Tick> ticks;
  if (colours.log10) {
    ticks = log_ticks(colours.low, colours.high, 6, unit);
  } else {
    ticks = linear_ticks(colours.low * shown.factor, colours.high * shown.factor, 6);
    for (Tick& tick : ticks) {
      tick.value /= shown.factor;
      if (!shown.name.empty()) tick.label += " " + shown.name;
    }
  }
  Html content = element("image",
                         {{"x", px(kStart)},
                          {"y", "4"},
                          {"width", px(kLong)},
                          {"height", "14"},
                          {"preserveAspectRatio", "none"},
                          {"href", colour_strip(colours)}},
                         {});
  for (const Tick& tick : ticks) {
    const double x = kStart + kLong * colour_position(colours, tick.value);
    content += svg_line(x, 18, x, 23, "#555555");
    content += svg_text(x, 36, "middle", tick.label, 12);
  }
  const std::string low = format_quantity(colours.low, unit),
                    high = format_quantity(colours.high, unit);
  return element(
      "figure", {{"style", "max-width: 30rem"}},
      svg(kLong + 2 * kStart, 42, name + " from " + low + " to " + high, content));
}

}  // namespace delos::report
