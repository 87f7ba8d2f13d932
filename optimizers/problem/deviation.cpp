#include "problem/deviation.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

namespace delos {
namespace {

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

PlacedDevice deviated(PlacedDevice device, const Deviation& by) {
  auto* carried = std::get_if<TargetMount>(&device.mount);
  Pose& X = carried ? carried->X_TS : device.X_WS();
  X.p += by.place;
  if (const double angle = by.turn.norm(); angle > 0)
    X.R = X.R * Eigen::AngleAxisd(angle, by.turn / angle).toRotationMatrix();
  device.noise *= std::exp(2 * by.noise);
  return device;
}

}  // namespace delos
