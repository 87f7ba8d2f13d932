#include "delos/optimize/layout.h"

#include <cmath>

#include "delos/scene/number.h"
#include "problem/assignment.h"

namespace delos {
namespace {

/// What a device is, without where it stands.
DeviceEntry nature(DeviceEntry device) {
  device.name.clear();
  device.group.clear();
  device.mounting.reset();
  device.placement = {};
  return device;
}

double turn_between(const Pose& a, const Pose& b) {
  const Eigen::Vector3d u = a.R.col(2), v = b.R.col(2);
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

std::vector<int> device_kinds(const Scene& scene, PluginRegistry& plugins) {
  Scene plain = scene;
  const auto forget = [&](const std::string& path) {
    *std::get<SceneNumber>(find_number(plain, path, plugins)).value = 0;
  };
  for (const VariableEntry& v : scene.variables) {
    forget(v.path);
    for (const Follower& f : v.followers) forget(f.path);
  }
  std::vector<int> kinds;
  std::vector<DeviceEntry> known;
  for (const DeviceEntry& device : plain.devices) {
    const DeviceEntry own = nature(device);
    std::size_t k = 0;
    while (k < known.size() && !(known[k] == own)) ++k;
    if (k == known.size()) known.push_back(own);
    kinds.push_back(static_cast<int>(k));
  }
  return kinds;
}

LayoutMatch match_layouts(const std::vector<int>& kinds, const std::vector<Pose>& first,
                          const std::vector<Pose>& second,
                          const Eigen::Vector3d& middle) {
  const std::size_t n = kinds.size();
  LayoutMatch match{std::vector<std::size_t>(n), std::vector<double>(n),
                    std::vector<double>(n), 0};
  const auto square = [&](std::size_t i, std::size_t j) {
    const double arm = (middle - first[i].p).norm();
    const double turned = arm * turn_between(first[i], second[j]);
    return (second[j].p - first[i].p).squaredNorm() + turned * turned;
  };
  double sum = 0;
  for (int kind = 0;; ++kind) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < n; ++i)
      if (kinds[i] == kind) members.push_back(i);
    if (members.empty()) break;
    const auto count = static_cast<Eigen::Index>(members.size());
    const Eigen::MatrixXd cost =
        Eigen::MatrixXd::NullaryExpr(count, count, [&](Eigen::Index i, Eigen::Index j) {
          return square(members[static_cast<std::size_t>(i)],
                        members[static_cast<std::size_t>(j)]);
        });
    const std::vector<std::size_t> to = cheapest_assignment(cost);
    for (std::size_t k = 0; k < members.size(); ++k) {
      const std::size_t i = members[k], j = members[to[k]];
      match.partner[i] = j;
      match.shift[i] = (second[j].p - first[i].p).norm();
      match.turn[i] = turn_between(first[i], second[j]);
      sum += square(i, j);
    }
  }
  if (n > 0) match.distance = std::sqrt(sum / static_cast<double>(n));
  return match;
}

const char* to_string(Settled settled) {
  switch (settled) {
    case Settled::settled:
      return "settled";
    case Settled::partly:
      return "partly";
    case Settled::free:
      return "free";
  }
  return "";
}

}  // namespace delos
