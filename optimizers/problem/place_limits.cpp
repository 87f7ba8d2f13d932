#include "problem/place_limits.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace delos {
namespace {

using Poses = std::vector<Pose>;

std::size_t index_of(const Scene& scene, const std::string& name) {
  const auto at = std::find_if(scene.devices.begin(), scene.devices.end(),
                               [&](const DeviceEntry& d) { return d.name == name; });
  return static_cast<std::size_t>(at - scene.devices.begin());
}

Region region_of(const Scene& scene, const std::string& name) {
  const auto at = std::find_if(scene.regions.begin(), scene.regions.end(),
                               [&](const RegionEntry& r) { return r.name == name; });
  return Region(transformed(body_mesh(at->body), pose_of(at->placement)));
}

double distance_to_line(const Eigen::Vector3d& p, const Eigen::Vector3d& from,
                        const Eigen::Vector3d& to) {
  const Eigen::Vector3d d = to - from;
  const double part = std::clamp((p - from).dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (p - from - part * d).norm();
}

}  // namespace

GeometryLimits::GeometryLimits(const Design& design) {
  const Scene& scene = design.scene();
  for (std::size_t c = 0; c < scene.constraints.size(); ++c) {
    std::visit(
        [&](const auto& keep) {
          using Keep = std::decay_t<decltype(keep)>;
          if constexpr (std::is_same_v<Keep, KeepSum>) {
            add(c, keep, design);
          } else if constexpr (!std::is_same_v<Keep, KeepMetric>) {
            add(c, keep, scene);
          }
        },
        scene.constraints[c].what);
  }
}

void GeometryLimits::push(std::size_t constraint, double scale,
                          std::function<double(const Poses&)> slack) {
  limits_.push_back({constraint, scale});
  slacks_.push_back(std::move(slack));
}

void GeometryLimits::add(std::size_t constraint, const KeepInside& keep,
                         const Scene& scene) {
  const auto region = std::make_shared<const Region>(region_of(scene, keep.region));
  for (const std::string& name : keep.devices)
    push(constraint, 0.1, [region, keep, i = index_of(scene, name)](const Poses& X) {
      const double distance = region->signed_distance(X[i].p);
      return (keep.outside ? distance : -distance) - keep.margin;
    });
}

void GeometryLimits::add(std::size_t constraint, const KeepApart& keep,
                         const Scene& scene) {
  for (std::size_t a = 0; a < keep.devices.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      push(constraint, keep.distance,
           [d = keep.distance, i = index_of(scene, keep.devices[a]),
            j = index_of(scene, keep.devices[b])](const Poses& X) {
             return (X[i].p - X[j].p).norm() - d;
           });
}

void GeometryLimits::add(std::size_t constraint, const KeepTilt& keep,
                         const Scene& scene) {
  for (const std::string& name : keep.devices)
    push(constraint, 0.1, [keep, i = index_of(scene, name)](const Poses& X) {
      const Eigen::Vector3d axis = X[i].R.col(2);
      return keep.angle - std::atan2(axis.cross(keep.from).norm(), axis.dot(keep.from));
    });
}

void GeometryLimits::add(std::size_t constraint, const KeepClear& keep,
                         const Scene& scene) {
  for (const std::string& name : keep.devices)
    push(constraint, keep.distance, [keep, i = index_of(scene, name)](const Poses& X) {
      return distance_to_line(X[i].p, keep.from, keep.to) - keep.distance;
    });
}

void GeometryLimits::add(std::size_t constraint, const KeepSum& keep,
                         const Design& design) {
  std::vector<std::pair<const double*, double>> terms;
  for (const auto& [path, factor] : keep.factors)
    terms.emplace_back(design.number(path), factor);
  push(constraint, std::max(std::abs(keep.limit), 1e-6),
       [terms, limit = keep.limit](const Poses&) {
         double sum = 0;
         for (const auto& [number, factor] : terms) sum += factor * *number;
         return limit - sum;
       });
}

void GeometryLimits::slacks(const Scene& scene, double* out) const {
  if (limits_.empty()) return;
  Poses poses;
  poses.reserve(scene.devices.size());
  for (const DeviceEntry& device : scene.devices)
    poses.push_back(device_pose(scene, device));
  for (std::size_t i = 0; i < slacks_.size(); ++i) out[i] = slacks_[i](poses);
}

}  // namespace delos
