#include "delos/field/device_use.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "observe/measure.h"

namespace delos {
namespace {

/// Halvings and doublings of a distance that are tried: to a billionth and back.
constexpr int kMostHalvings = 30;

/// Asks one device what it would see.
class Asker {
 public:
  Asker(const System& system, const PlacedDevice& placed)
      : system_(system),
        placed_(placed),
        columns_(information_size(system)),
        R_SW_(placed.X_WS().R.transpose()) {
    scratch_.target.state.setZero(system.motion.layout.size());
    scratch_.target.own.setZero(placed.own.size);
  }

  /// Whether it sees the target, with all that stands in between.
  bool sees(const TargetPose& X_WT) {
    return measure(system_, placed_, X_WT, columns_, scratch_, [](const auto&...) {});
  }
  /// Whether it would see any of the target if nothing hid it and all of it stood at
  /// `stretch` times its distance.
  bool in_view(const TargetPose& X_WT, double stretch = 1) {
    if (placed_.device->span() != Span::point) {
      const Eigen::Vector3d p = R_SW_ * (X_WT.p - placed_.X_WS().p);
      return observes(stretch * p, R_SW_ * X_WT.R);
    }
    return std::any_of(
        system_.markers.begin(), system_.markers.end(),
        [&](const PlacedMarker& marker) {
          return observes(stretch * (R_SW_ * (X_WT * marker.p - placed_.X_WS().p)));
        });
  }
  /// Whether it observes a target at p, in its own frame.
  bool observes(const Eigen::Vector3d& p,
                const Eigen::Matrix3d& R_ST = Eigen::Matrix3d::Identity()) {
    scratch_.target.p_ST = p;
    scratch_.target.R_ST = R_ST;
    return ask(placed_, [&](const Device& device) {
      return device.observe(scratch_.target, scratch_.observation);
    });
  }

 private:
  const System& system_;
  const PlacedDevice& placed_;
  const int columns_;
  const Eigen::Matrix3d R_SW_;
  MeasureScratch scratch_;
};

/// The last x from `good` towards `bad` at which `holds`, to a thousandth or so.
template <class Holds>
double last_that(double good, double bad, const Holds& holds) {
  for (int i = 0; i < 20; ++i) {
    const double middle = (good + bad) / 2;
    (holds(middle) ? good : bad) = middle;
  }
  return good;
}

/// The factor of a place's distance nearest to one at which the device sees it, by
/// halving or doubling.
std::optional<double> stretch_in_view(Asker& ask, const TargetPose& pose, double by) {
  double stretch = 1;
  for (int i = 0; i < kMostHalvings; ++i) {
    stretch *= by;
    if (ask.in_view(pose, stretch))
      return last_that(stretch, stretch / by,
                       [&](double s) { return ask.in_view(pose, s); });
  }
  return std::nullopt;
}

}  // namespace

DeviceUse device_use(const System& system, const PlacedDevice& placed,
                     const std::vector<TargetPose>& poses) {
  DeviceUse use;
  use.places = poses.size();
  use.nearest = use.least_reach = std::numeric_limits<double>::infinity();
  Asker ask(system, placed);
  const Eigen::Vector3d& device = placed.X_WS().p;
  for (const TargetPose& pose : poses) {
    const double distance = (pose.p - device).norm();
    use.nearest = std::min(use.nearest, distance);
    use.farthest = std::max(use.farthest, distance);
    use.sees_thousandth += ask.in_view(pose, 1e-3);
    if (ask.sees(pose)) {
      ++use.sees;
    } else if (ask.in_view(pose)) {
      ++use.hidden;
      const double way = std::min(distance, DeviceUse::kAtOnce);
      use.at_once += system.in_world.blocks(
          device, device + (pose.p - device).normalized() * way, system.skin);
    } else if (const auto nearer = stretch_in_view(ask, pose, 0.5)) {
      ++use.too_far;
      use.reach = std::max(use.reach, *nearer * distance);
    } else if (const auto farther = stretch_in_view(ask, pose, 2)) {
      ++use.too_near;
      use.least_reach = std::min(use.least_reach, *farther * distance);
    } else {
      ++use.aside;
    }
  }
  return use;
}

std::size_t in_view(const System& system, const PlacedDevice& placed,
                    const std::vector<TargetPose>& poses) {
  Asker ask(system, placed);
  return static_cast<std::size_t>(
      std::count_if(poses.begin(), poses.end(),
                    [&](const TargetPose& pose) { return ask.in_view(pose); }));
}

double field_of_view(const System& system, const PlacedDevice& placed,
                     const std::vector<TargetPose>& poses) {
  Asker ask(system, placed);
  // A line on which it sees something: to a place, or along an axis.
  std::optional<Eigen::Vector3d> seen;
  const Pose X_SW = placed.X_WS().inverse();
  std::vector<Eigen::Vector3d> tried;
  double distance = 1;
  for (const TargetPose& pose : poses) {
    tried.push_back(X_SW * pose.p);
    distance = std::max(distance, tried.back().norm());
  }
  for (int i = 0; i < 6; ++i)
    for (const double part : {1e-2, 0.1, 1.0})
      tried.emplace_back((i % 2 == 0 ? 1 : -1) * part * distance *
                         Eigen::Vector3d::Unit(i / 2));
  // The axes first: about one of them most views are symmetric.
  const auto at = std::find_if(tried.rbegin(), tried.rend(),
                               [&](const auto& p) { return ask.observes(p); });
  if (at == tried.rend()) return std::numeric_limits<double>::quiet_NaN();
  seen = *at;

  const Eigen::Vector3d across = seen->unitOrthogonal();
  constexpr double kPi = std::numbers::pi;
  const auto edge = [&](double turn) {  // the angle up to which it sees, that way
    const Eigen::Vector3d axis = Eigen::AngleAxisd(turn, seen->normalized()) * across;
    const auto holds = [&](double angle) {
      return ask.observes(Eigen::AngleAxisd(angle, axis) * *seen);
    };
    double good = 0;
    for (double angle = 1e-6; angle < kPi; angle *= 1.5) {
      if (!holds(angle)) return last_that(good, angle, holds);
      good = angle;
    }
    return kPi;
  };
  double widest = 0;
  for (int i = 0; i < 4; ++i)
    widest = std::max(widest, edge(i * kPi / 4) + edge(i * kPi / 4 + kPi));
  return widest;
}

}  // namespace delos
