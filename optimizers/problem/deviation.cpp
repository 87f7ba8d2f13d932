#include "problem/deviation.h"

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace delos {
namespace {

/// A device whose noise is larger or smaller.
class NoisyDevice final : public Device {
 public:
  /// @param factor of its covariance
  NoisyDevice(std::shared_ptr<const Device> device, double factor)
      : device_(std::move(device)), factor_(factor) {}

  [[nodiscard]] const std::shared_ptr<const Device>& device() const { return device_; }
  [[nodiscard]] double factor() const { return factor_; }

  [[nodiscard]] Span span() const override { return device_->span(); }
  [[nodiscard]] int state_size() const override { return device_->state_size(); }
  [[nodiscard]] bool observe(const Target& target, Observation& out) const override {
    if (!device_->observe(target, out)) return false;
    out.R *= factor_;
    return true;
  }
  [[nodiscard]] bool observe_lanes(const PointLanes& points,
                                   RowLanes& out) const override {
    return device_->observe_lanes(points, out) && scaled(out);
  }
  [[nodiscard]] bool observe_smoothly(const Eigen::Vector3d& p,
                                      SmoothRows& out) const override {
    if (!device_->observe_smoothly(p, out)) return false;
    out.variance.head(out.rows) *= factor_;
    out.variance_slope.topRows(out.rows) *= factor_;
    return true;
  }
  [[nodiscard]] View view_of_ball(const Eigen::Vector3d& center,
                                  double radius) const override {
    return device_->view_of_ball(center, radius);
  }
  [[nodiscard]] int views() const override { return device_->views(); }
  [[nodiscard]] ViewCone view_cone(int view) const override {
    return device_->view_cone(view);
  }
  [[nodiscard]] std::string view_name(int view) const override {
    return device_->view_name(view);
  }
  [[nodiscard]] bool observe_view(int view, const Target& target,
                                  Observation& out) const override {
    if (!device_->observe_view(view, target, out)) return false;
    out.R *= factor_;
    return true;
  }
  [[nodiscard]] bool observe_view_lanes(int view, const BeaconLanes& beacons,
                                        RowLanes& out) const override {
    return device_->observe_view_lanes(view, beacons, out) && scaled(out);
  }
  [[nodiscard]] bool needs_sight() const override { return device_->needs_sight(); }

 private:
  bool scaled(RowLanes& out) const {
    for (int row = 0; row < out.rows; ++row)
      for (double& variance : out.variance[row]) variance *= factor_;
    return true;
  }

  std::shared_ptr<const Device> device_;
  double factor_;
};

/// FNV-1a, so that a device keeps its numbers whatever stands beside it.
std::uint64_t hash(const std::string& text) {
  std::uint64_t h = 14695981039346656037ull;
  for (const unsigned char c : text) h = (h ^ c) * 1099511628211ull;
  return h;
}

/// Two independent standard normal numbers, by Box and Muller: those of <random> differ
/// between libraries.
Eigen::Vector2d normal_pair(std::mt19937_64& random) {
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const double radius = std::sqrt(-2 * std::log(1 - unit()));
  const double angle = 2 * std::numbers::pi * unit();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

Deviation deviation(const Robustness& robust, int draw, const std::string& device) {
  const std::uint64_t name = hash(device);
  std::seed_seq sequence{
      static_cast<std::uint32_t>(robust.seed), static_cast<std::uint32_t>(draw / 2),
      static_cast<std::uint32_t>(name), static_cast<std::uint32_t>(name >> 32)};
  std::mt19937_64 random(sequence);
  Eigen::Matrix<double, 8, 1> z;
  for (int i = 0; i < 8; i += 2) z.segment<2>(i) = normal_pair(random);
  if (draw % 2 == 1) z = -z;
  return {robust.place * z.head<3>(), robust.angle * z.segment<3>(3),
          robust.noise * z(6)};
}

PlacedDevice deviated(const PlacedDevice& device, const Deviation& by,
                      const PlacedDevice* previous) {
  PlacedDevice out = device;
  Pose& X = device.beacons ? out.X_TS : out.X_WS;
  X.p += by.place;
  if (const double angle = by.turn.norm(); angle > 0)
    X.R = X.R * Eigen::AngleAxisd(angle, by.turn / angle).toRotationMatrix();
  if (by.noise == 0) return out;
  const double factor = std::exp(2 * by.noise);
  const auto* noisy =
      previous ? dynamic_cast<const NoisyDevice*>(previous->device.get()) : nullptr;
  if (noisy && noisy->device() == device.device && noisy->factor() == factor)
    out.device = previous->device;
  else
    out.device = std::make_shared<NoisyDevice>(device.device, factor);
  return out;
}

}  // namespace delos
