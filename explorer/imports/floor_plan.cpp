#include "imports/floor_plan.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "delos/text/units.h"
#include "delos/text/words.h"

namespace delos::imports {
namespace {

constexpr double kCeiling = 2.5, kBreast = 1.2;  // metres

/// Twice the signed area, by Gauss's formula.
double twice_area(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.corners.size(); ++i) {
    const Eigen::Vector2d &a = outline.corners[i],
                          &b = outline.corners[(i + 1) % outline.corners.size()];
    sum += a.x() * b.y() - b.x() * a.y();
  }
  return sum;
}

std::string prism_text(const Outline& outline, const std::string& name, double height,
                       bool room) {
  std::vector<std::string> corners;
  for (const Eigen::Vector2d& p : outline.corners) corners.push_back(list_text(p));
  return "{name: " + name + ", prism: {polygon: [" + joined(corners) +
         "], height: " + shortest(height) + "}" + (room ? ", room: true" : "") + "}";
}

/// The corner that is farthest along a diagonal, and a little inwards.
Eigen::Vector2d corner_along(const Outline& room, const Eigen::Vector2d& way) {
  const auto farthest = std::max_element(
      room.corners.begin(), room.corners.end(),
      [&](const auto& a, const auto& b) { return a.dot(way) < b.dot(way); });
  return *farthest - 0.1 * way;
}

}  // namespace

void furnish(Rig& rig, std::vector<Outline> outlines, const ImportOptions& options,
             Source& source) {
  constexpr std::size_t kMostOutlines = 1000;
  if (outlines.empty() || outlines.size() > kMostOutlines) {
    source.error(
        0, outlines.empty() ? "has no closed outline" : "has more than 1000 outlines");
    return;
  }
  std::stable_sort(outlines.begin(), outlines.end(), [](const auto& a, const auto& b) {
    return std::abs(twice_area(a)) > std::abs(twice_area(b));
  });
  const Outline& room = outlines.front();
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : room.corners) box.extend(p);
  const double wide = box.sizes().maxCoeff();
  if (!(wide > 0.5) || !(wide < 2000)) {
    source.error(0,
                 "its room is " + shortest(wide) +
                     " m wide; which unit is it in? --unit mm, --unit '0.02 m' says");
    return;
  }
  const double height =
      options.height.value_or(room.height > 0 ? room.height : kCeiling);
  if (!options.height && !(room.height > 0))
    rig.assumed.emplace_back("rooms are 2.5 m high; --height says otherwise");
  std::size_t number = 0;
  for (const Outline& outline : outlines) {
    const bool is_room = number == 0;
    const std::string name = is_room ? "room" : "body" + std::to_string(number);
    const double own = !is_room && outline.height > 0 ? outline.height : height;
    rig.occluders.push_back(prism_text(outline, name, own, is_room));
    ++number;
  }
  rig.facts.push_back("the largest outline, " + shortest(box.sizes().x()) + " m by " +
                      shortest(box.sizes().y()) + " m, is the room; " +
                      counted(outlines.size() - 1, "outline") +
                      " in it or beside it are solid");
  int corner = 0;
  for (const Eigen::Vector2d& way :
       {Eigen::Vector2d(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
    RigDevice d;
    d.name = "anchor" + std::to_string(++corner);
    d.type = "uwb_range";
    d.rate = "10 Hz";
    d.rate_remark = "assumed";
    const Eigen::Vector2d at = corner_along(room, way);
    d.placement.at = {at.x(), at.y(), corner % 2 == 0 ? 0.3 : height - 0.2};
    rig.devices.push_back(std::move(d));
  }
  rig.assumed.emplace_back(
      "four UWB anchors near its corners, high and low: a plan has "
      "no devices, put your own in their place");
  // Not on the walls, where nothing is seen.
  const Eigen::Vector2d low = box.min().array() + 0.05 * wide,
                        size = box.sizes().array() - 0.1 * wide;
  constexpr int kAlong = 41;
  const Eigen::Vector2i counts =
      (size.array() / wide * (kAlong - 1)).ceil().cast<int>().max(1) + 1;
  rig.sample =
      "plane: {origin: " + list_text(Eigen::Vector3d(low.x(), low.y(), kBreast)) +
      ", u: " + list_text(Eigen::Vector3d(size.x(), 0, 0)) +
      ", v: " + list_text(Eigen::Vector3d(0, size.y(), 0)) + ", counts: [" +
      std::to_string(counts.x()) + ", " + std::to_string(counts.y()) + "]}";
  rig.assumed.emplace_back("samples lie 1.2 m above the floor");
  assume_rest(rig, {}, source);
}

}  // namespace delos::imports
