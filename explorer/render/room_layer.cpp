#include "render/room_layer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "delos/device/beacons.h"
#include "delos/geometry/primitives.h"
#include "delos/scene/clutter.h"
#include "render/solids.h"
#include "session/description.h"
#include "session/view_outline.h"

namespace delos::render {
namespace {

/// How far frusta are drawn, of the depth of their outline.
constexpr double kFrustum = 0.28;
/// Beyond so many devices, icons are small and frusta left out; names beyond fewer.
constexpr std::size_t kMany = 60, kMostNames = 40;

class RoomPainter {
 public:
  RoomPainter(const Pen& pen, const session::LoadedScene& loaded)
      : pen_(pen),
        loaded_(loaded),
        room_(session::room_box(loaded)),
        samples_(session::sample_box(loaded.scene)) {}

  void box() {
    // Of flat samples it is flat.
    const Eigen::Vector3d max =
        samples_.max().cwiseMax(samples_.min() + Eigen::Vector3d::Constant(1e-9));
    for (const auto& [a, b] : sharp_edges(make_box(samples_.min(), max)))
      line(a, b, pen_.ground.lines);
  }

  /// Squares of a round length, about ten of them, a little below the lowest sample.
  void floor() {
    const Eigen::Vector3d size = room_.sizes();
    const double rough = std::max({size.x(), size.y(), 1e-3}) / 10;
    const double decade = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * decade;
    for (const double m : {5, 2, 1})
      if (m * decade >= rough) step = m * decade;
    const double z = room_.min().z() - std::max(size.x(), size.y()) / 100;
    const auto low = [&](int k) { return std::floor(room_.min()[k] / step); };
    const auto high = [&](int k) { return std::ceil(room_.max()[k] / step); };
    for (double i = low(0); i <= high(0); ++i)
      line({i * step, low(1) * step, z}, {i * step, high(1) * step, z},
           pen_.ground.faint);
    for (double i = low(1); i <= high(1); ++i)
      line({low(0) * step, i * step, z}, {high(0) * step, i * step, z},
           pen_.ground.faint);
  }

  /// What moves with the target has no place of its own in the room.
  void bodies() {
    for (const OccluderEntry& entry : all_occluders(loaded_.scene)) {
      if (entry.mount == Mount::target) continue;
      const TriangleMesh mesh =
          transformed(body_mesh(entry.body), pose_of(entry.placement));
      // The inside of a room is what one looks at: its walls are lines alone.
      if (!entry.room) solid(mesh, pen_.ground.bodies);
      for (const auto& [a, b] : sharp_edges(mesh)) line(a, b, pen_.ground.lines);
    }
  }

  void beacons() {
    for (const BeaconSet& set : loaded_.scene.beacons)
      for (const Beacon& beacon : lit_beacons(set))
        pen_.raster.disc(pen_.eye, pen_.eye.seen(beacon.p), 1.5, false,
                         pen_.ground.beacons);
  }

  std::vector<Label> devices(const PictureOptions& options) {
    std::vector<Label> names;
    const double reach = room_.diagonal().norm();
    std::vector<const PlacedDevice*> placed;
    for (const PlacedDevice& device : loaded_.system.devices)
      if (!device.carried()) placed.push_back(&device);
    const bool many = placed.size() > kMany;
    const double size = 0.032 * std::max(reach, 1e-3) * (many ? 0.5 : 1);
    for (const PlacedDevice* device : placed) {
      const Pose& X_WS = device->X_WS();
      const std::vector<Eigen::Vector3d> outline =
          session::view_outline(*device->device, reach > 0 ? reach / 4 : 1);
      solid(
          transformed(outline.empty() ? make_sphere(0.42 * size, 2) : camera_icon(size),
                      X_WS),
          pen_.ground.device);
      if (options.frusta && !many) frustum(outline, X_WS);
      const Eigen::Vector3d seen = pen_.eye.seen(X_WS.p);
      if (options.names && placed.size() <= kMostNames && seen.z() > pen_.eye.nearest())
        names.push_back({pen_.eye.spot(seen), device->name});
    }
    for (Label& label : names) {
      label.spot.x /= Raster::kFiner;
      label.spot.y /= Raster::kFiner;
    }
    return names;
  }

 private:
  void line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Colour& colour) {
    pen_.raster.line(pen_.eye, pen_.eye.seen(a), pen_.eye.seen(b), colour);
  }

  void frustum(const std::vector<Eigen::Vector3d>& outline, const Pose& X_WS) {
    if (outline.empty()) return;
    const auto placed = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return X_WS * (kFrustum * p);
    };
    for (std::size_t i = 0; i < outline.size(); ++i)
      line(placed(outline[i]), placed(outline[(i + 1) % outline.size()]),
           pen_.ground.sight);
    for (const Eigen::Vector3d& corner : corners_of(outline))
      line(X_WS.p, placed(corner), pen_.ground.sight);
  }

  /// Light falls from behind the eye, and a little from above.
  void solid(const TriangleMesh& mesh, const Colour& colour) {
    for (const auto& t : mesh.triangles) {
      std::array<Corner, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = {pen_.eye.seen(mesh.vertices[t[k]]), Eigen::Vector3d::Zero()};
      const Eigen::Vector3d a = mesh.vertices[t[0]];
      const Eigen::Vector3d up =
          (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized();
      const Eigen::Vector3d seen = (corners[1].seen - corners[0].seen)
                                       .cross(corners[2].seen - corners[0].seen)
                                       .normalized();
      const double light = 0.55 + 0.3 * std::abs(seen.z()) + 0.15 * std::abs(up.z());
      pen_.raster.triangle(pen_.eye, corners, [&](const Eigen::Vector3d&, int, int) {
        return lit(colour, light);
      });
    }
  }

  const Pen& pen_;
  const session::LoadedScene& loaded_;
  Eigen::AlignedBox3d room_, samples_;
};

}  // namespace

std::vector<Label> draw_room_layer(const Pen& pen, const session::LoadedScene& loaded,
                                   const PictureOptions& options) {
  RoomPainter painter(pen, loaded);
  if (options.floor) painter.floor();
  if (options.box) painter.box();
  if (options.bodies) painter.bodies();
  if (options.beacons) painter.beacons();
  return options.devices ? painter.devices(options) : std::vector<Label>{};
}

}  // namespace delos::render
