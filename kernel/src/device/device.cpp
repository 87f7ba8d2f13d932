#include "delos/device/device.h"

namespace delos {

// The first virtual function outside the class: it keeps one type record of Device in
// the kernel's library, whatever plugins are open.
Device::~Device() = default;

double Device::period(int) const { return 0; }

Eigen::Vector3d Device::shared_variance() const { return Eigen::Vector3d::Zero(); }

bool Device::observe_lanes(const PointLanes&, RowLanes&) const { return false; }

bool Device::observe_smoothly(const Eigen::Vector3d&, SmoothRows&) const {
  return false;
}

double Device::footprint(const Eigen::Vector3d&) const { return 0; }

View Device::view_of_ball(const Eigen::Vector3d&, double) const {
  return View::unknown;
}

ViewCone Device::view_cone(int) const { return {}; }

std::string Device::view_name(int view) const { return "view " + std::to_string(view); }

bool Device::observe_view(int, const Target& target, Observation& out) const {
  return observe(target, out);
}

bool Device::observe_view_lanes(int, const BeaconLanes&, RowLanes&) const {
  return false;
}

}  // namespace delos
