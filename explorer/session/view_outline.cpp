#include "session/view_outline.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace delos::session {
namespace {

constexpr int kDirections = 180;
constexpr double kWidest = 1.4;  ///< half-angle of what is shown as a cone, radians
constexpr int kHalvings = 24;

class Looker {
 public:
  explicit Looker(const Device& device) : device_(device) {
    target_.own.setZero(static_cast<Eigen::Index>(device.states().size()));
  }

  bool sees(const Eigen::Vector3d& p) {
    target_.p_ST = p;
    return device_.observe(target_, observation_);
  }

 private:
  const Device& device_;
  Target target_;
  Observation observation_;
};

/// A distance along the axis at which it sees, as near to the one asked for as halving
/// and doubling finds.
std::optional<double> seen_depth(Looker& look, double depth) {
  double nearer = depth, farther = depth;
  for (int i = 0; i < kHalvings; ++i, nearer /= 2, farther *= 2)
    for (const double d : {nearer, farther})
      if (look.sees({0, 0, d})) return d;
  return std::nullopt;
}

}  // namespace

std::vector<Eigen::Vector3d> view_outline(const Device& device, double depth) {
  if (device.span() != Span::point && device.span() != Span::pose) return {};
  Looker look(device);
  const std::optional<double> z = seen_depth(look, depth);
  if (!z) return {};
  std::vector<Eigen::Vector3d> edge;
  for (int i = 0; i < kDirections; ++i) {
    const double around = 2 * std::numbers::pi * i / kDirections;
    const auto at = [&](double angle) {
      const double r = *z * std::tan(angle);
      return Eigen::Vector3d(r * std::cos(around), r * std::sin(around), *z);
    };
    double in = 0, out = kWidest;
    if (look.sees(at(out))) return {};
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (in + out) / 2;
      (look.sees(at(middle)) ? in : out) = middle;
    }
    edge.push_back(at(in));
  }
  return edge;
}

}  // namespace delos::session
