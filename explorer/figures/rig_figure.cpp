#include "figures/rig_figure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "delos/sampling/samples.h"
#include "figures/svg.h"
#include "output/ticks.h"
#include "session/view_outline.h"

namespace delos::figures {
namespace {

constexpr double kViewWide = 430, kViewHigh = 430;  // of one view, with its axes
constexpr double kRigLeft = 52, kRigBottom = 46, kRigTop = 30, kRigRight = 10;

/// A device that stands in the world.
struct DrawnDevice {
  std::string name;
  Eigen::Vector3d at;
  std::vector<Eigen::Vector3d>
      view;  ///< the edge of its view, in the world; may be empty
};

/// One view: what goes right and what goes up.
struct RigView {
  const char* title;
  int across, up;
  double left;          ///< of the drawing
  Eigen::Vector2d low;  ///< metres
  double scale;         ///< drawing units a metre

  [[nodiscard]] Eigen::Vector2d on(const Eigen::Vector3d& p) const {
    return {left + kRigLeft + (p[across] - low.x()) * scale,
            kViewHigh - kRigBottom - (p[up] - low.y()) * scale};
  }
};

/// The convex hull, counter-clockwise, by Andrew's monotone chain.
std::vector<Eigen::Vector2d> hull_of(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Eigen::Vector2d> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Eigen::Vector2d& p : points) {
      while (hull.size() >= start + 2) {
        const Eigen::Vector2d a = hull[hull.size() - 1] - hull[hull.size() - 2],
                              b = p - hull[hull.size() - 1];
        if (a.x() * b.y() - a.y() * b.x() > 0) break;
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

std::vector<DrawnDevice> drawn_devices(const System& system,
                                       const Eigen::Vector3d& centre) {
  std::vector<DrawnDevice> all;
  for (const PlacedDevice& device : system.devices) {
    if (device.carried()) continue;
    const Pose& X = device.X_WS();
    DrawnDevice drawn{device.name, X.p, {}};
    const double half_way = std::max((centre - X.p).norm() / 2, 1e-3);
    for (const Eigen::Vector3d& p : session::view_outline(*device.device, half_way))
      drawn.view.push_back(X * p);
    all.push_back(std::move(drawn));
  }
  return all;
}

Html polygon(const std::vector<Eigen::Vector2d>& corners) {
  std::string points;
  for (const Eigen::Vector2d& p : corners)
    points += (points.empty() ? "" : " ") + px(p.x()) + "," + px(p.y());
  return element("polygon",
                 {{"points", points},
                  {"fill", "#4393c3"},
                  {"fill-opacity", "0.12"},
                  {"stroke", "#4393c3"},
                  {"stroke-opacity", "0.6"}},
                 {});
}

Html frame_of_view(const RigView& view, const Eigen::Vector2d& high) {
  const char* kNames[] = {"x [m]", "y [m]", "z [m]"};
  const double bottom = kViewHigh - kRigBottom, left = view.left + kRigLeft;
  const double width = (high.x() - view.low.x()) * view.scale,
               height = (high.y() - view.low.y()) * view.scale;
  Html out = svg_text(left, bottom - height - 8, "start", view.title, 14);
  for (const Tick& tick : linear_ticks(view.low.x(), high.x(), 5)) {
    const double x = left + (tick.value - view.low.x()) * view.scale;
    out += svg_line(x, bottom, x, bottom + 4, "#555555");
    out += svg_text(x, bottom + 17, "middle", tick.label, 12);
  }
  for (const Tick& tick : linear_ticks(view.low.y(), high.y(), 5)) {
    const double y = bottom - (tick.value - view.low.y()) * view.scale;
    out += svg_line(left - 4, y, left, y, "#555555");
    out += svg_text(left - 6, y + 4, "end", tick.label, 12);
  }
  out += element("rect",
                 {{"x", px(left)},
                  {"y", px(bottom - height)},
                  {"width", px(width)},
                  {"height", px(height)},
                  {"fill", "none"},
                  {"stroke", "#555555"}},
                 {});
  out += svg_text(left + width / 2, bottom + 36, "middle", kNames[view.across]);
  return out + svg_text_upwards(view.left + 14, bottom - height / 2, kNames[view.up]);
}

Html view_figure(const RigView& view, const std::vector<DrawnDevice>& devices,
                 const Eigen::AlignedBox3d& samples) {
  Html out;
  for (const DrawnDevice& d : devices) {
    if (d.view.empty()) continue;
    std::vector<Eigen::Vector2d> corners = {view.on(d.at)};
    for (const Eigen::Vector3d& p : d.view) corners.push_back(view.on(p));
    out += polygon(hull_of(std::move(corners)));
  }
  if (!samples.isEmpty()) {
    const Eigen::Vector2d a = view.on(samples.min()), b = view.on(samples.max());
    out += element("rect",
                   {{"x", px(a.x())},
                    {"y", px(b.y())},
                    {"width", px(b.x() - a.x())},
                    {"height", px(a.y() - b.y())},
                    {"fill", "none"},
                    {"stroke", "#333333"},
                    {"stroke-dasharray", "5 4"}},
                   {});
  }
  constexpr std::size_t kNamedDevices = 16;  // names of more would cover each other
  for (const DrawnDevice& d : devices) {
    const Eigen::Vector2d p = view.on(d.at);
    out += element("circle",
                   {{"cx", px(p.x())},
                    {"cy", px(p.y())},
                    {"r", "4"},
                    {"fill", "#b2182b"},
                    {"stroke", "#ffffff"}},
                   element("title", d.name));
    if (devices.size() > kNamedDevices) continue;
    const bool right = p.x() > view.left + kViewWide / 2;
    out += element(
        "g", {{"paint-order", "stroke"}, {"stroke", "#ffffff"}, {"stroke-width", "3"}},
        svg_text(p.x() + (right ? -7 : 7), p.y() - 6, right ? "end" : "start", d.name,
                 12));
  }
  return out;
}

}  // namespace

std::string rig_figure(const Scene& scene, const System& system) {
  Eigen::AlignedBox3d samples, all;
  for (const SampleSet& set : scene.samples) {
    if (const auto* octree = std::get_if<AdaptiveSampling>(&set.shape)) {
      samples.extend(octree->min).extend(octree->max);
      continue;
    }
    for (const Eigen::Vector3d& p : make_samples({set}).points) samples.extend(p);
  }
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  if (!samples.isEmpty()) centre = samples.center();
  const auto devices = drawn_devices(system, centre);
  all = samples;
  for (const DrawnDevice& d : devices) {
    all.extend(d.at);
    for (const Eigen::Vector3d& p : d.view) all.extend(p);
  }
  const Eigen::Vector3d border =
      Eigen::Vector3d::Constant(0.05 * std::max(all.diagonal().norm(), 0.1));
  all.extend(all.min() - border).extend(all.max() + border);
  const Eigen::Vector3d wide = all.sizes();
  const double scale =
      std::min((kViewWide - kRigLeft - kRigRight) / std::max(wide.x(), wide.y()),
               (kViewHigh - kRigBottom - kRigTop) / std::max(wide.y(), wide.z()));
  Html content;
  const RigView views[] = {
      {"from above", 0, 1, 0, all.min().head<2>(), scale},
      {"from the side", 0, 2, kViewWide, {all.min().x(), all.min().z()}, scale}};
  for (const RigView& view : views) {
    content += view_figure(view, devices, samples);
    content += frame_of_view(view, {all.max()[view.across], all.max()[view.up]});
  }
  return svg(2 * kViewWide, kViewHigh,
             "Devices, what they see up to half of the way to the samples, and the box "
             "around the samples, from above and from the side",
             content)
             .str() +
         "\n";
}

}  // namespace delos::figures
