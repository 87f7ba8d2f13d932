#include "output/picture_frame.h"

#include <algorithm>
#include <cmath>

namespace delos {
namespace {

constexpr Rgb kDevice{0.7, 0.09, 0.17};
constexpr Rgb kRim{1, 1, 1};
const TextStyle kDeviceName{.size = 12, .bold = true, .colour = {0.45, 0.05, 0.1}};

/// The world's axis that a side runs along; nullopt along a tilted edge.
std::optional<int> world_axis(const SliceAxis& axis) {
  for (int i = 0; i < 3; ++i)
    if (axis.name == std::string(1, static_cast<char>('x' + i))) return i;
  return std::nullopt;
}

}  // namespace

PictureFrame picture_frame(const Slice& slice, const std::vector<Marker>& devices) {
  PictureFrame frame;
  for (const std::size_t s : {0, 1})
    frame.side[s] = {slice.axis[s].low(), slice.axis[s].span()};
  const auto across = world_axis(slice.axis[0]), up = world_axis(slice.axis[1]);
  if (!across || !up) return frame;
  frame.axis = {*across, *up};
  const double reach = std::max(frame.side[0].span, frame.side[1].span);
  std::array<double, 2> low, high;
  for (const std::size_t s : {0, 1}) {
    low[s] = frame.side[s].low;
    high[s] = low[s] + frame.side[s].span;
  }
  for (const Marker& device : devices) {
    const auto near = [&](std::size_t s) {
      const double at = device.p[frame.axis[s]] - frame.side[s].low;
      return at >= -reach && at <= frame.side[s].span + reach;
    };
    if (!near(0) || !near(1)) continue;
    frame.devices.push_back(device);
    for (const std::size_t s : {0, 1}) {
      low[s] = std::min(low[s], device.p[frame.axis[s]]);
      high[s] = std::max(high[s], device.p[frame.axis[s]]);
    }
  }
  if (frame.devices.empty()) return frame;
  const double border = 0.04 * std::max(high[0] - low[0], high[1] - low[1]);
  for (const std::size_t s : {0, 1})
    frame.side[s] = {low[s] - border, high[s] - low[s] + 2 * border};
  return frame;
}

Box PictureFrame::slice_box(const Box& plot, const Slice& slice) const {
  const auto fraction = [&](std::size_t s, double part) {
    return side[s].fraction_of(slice.axis[s].low() + part * slice.axis[s].span());
  };
  const double left = std::round(plot.x + plot.width * fraction(0, 0)),
               right = std::round(plot.x + plot.width * fraction(0, 1)),
               bottom = std::round(plot.bottom() - plot.height * fraction(1, 0)),
               top = std::round(plot.bottom() - plot.height * fraction(1, 1));
  return {left, top, std::max(1.0, right - left), std::max(1.0, bottom - top)};
}

void draw_devices(Canvas& canvas, const Box& plot, const PictureFrame& frame) {
  constexpr double kLength = 22, kRadius = 4.5;
  constexpr std::size_t kNamed = 12;  // names of more would cover each other
  for (const Marker& device : frame.devices) {
    const auto along = [&](std::size_t s, const Eigen::Vector3d& v) {
      return v[frame.axis[s]];
    };
    const double x =
        plot.x + plot.width * frame.side[0].fraction_of(along(0, device.p));
    const double y =
        plot.bottom() - plot.height * frame.side[1].fraction_of(along(1, device.p));
    if (device.faces) {
      const double to_x = x + kLength * along(0, *device.faces);
      const double to_y = y - kLength * along(1, *device.faces);
      canvas.line(x, y, to_x, to_y, kRim, 4.5);
      canvas.line(x, y, to_x, to_y, kDevice, 2.5);
    }
    canvas.disc(x, y, kRadius + 1, kRim);
    canvas.disc(x, y, kRadius, kDevice);
    if (frame.devices.size() > kNamed) continue;
    const bool right = x > plot.x + plot.width / 2;
    const double width = canvas.text_width(device.name, kDeviceName);
    const double text_y = y < plot.y + 20 ? y + 17 : y - 8;
    canvas.fill({right ? x - 8 - width : x + 8, text_y - 11, width, 14}, kRim, 0.7);
    canvas.text(right ? x - 8 : x + 8, text_y, right ? 1 : 0, device.name, kDeviceName);
  }
}

}  // namespace delos
