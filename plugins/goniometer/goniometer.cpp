// An instrument that measures the direction of a point by two angles of constant noise:
// a theodolite, a total station without its range, a gimballed tracker. x right, y
// down, z forward; its standing axis is y.
//
//   azimuth    α = atan2(x, z)
//   elevation  β = atan2(−y, ρ),   ρ = √(x² + z²)
//
//   R = diag(sigma_azimuth², sigma_elevation²)
//
// Seen at most half_angle off z, within ±highest of the horizon, and within reach.
#include <delos/device/axis_cone.h>
#include <delos/device/point_device.h>
#include <delos/plugin.h>

#include <numbers>

namespace {

using delos::number;

class Goniometer final : public delos::PointDevice<Goniometer, 2> {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      number("sigma_azimuth", "rad", "Standard deviation of the azimuth.").at_least(0),
      number("sigma_elevation", "rad", "Standard deviation of the elevation.")
          .at_least(0),
      number("half_angle", "rad", "Greatest angle to its z axis that is seen.")
          .initially(std::numbers::pi)
          .between(1e-6, std::numbers::pi),
      number("highest", "rad", "Greatest elevation, up and down, that is seen.")
          .initially(1.5)
          .between(1e-6, 1.57),
      number("reach", "m", "Farthest point that is seen.")
          .initially(1000)
          .at_least(1e-6),
  };

  explicit Goniometer(const delos::ParamValues& p)
      : variance_{p["sigma_azimuth"] * p["sigma_azimuth"],
                  p["sigma_elevation"] * p["sigma_elevation"]},
        round_(p["half_angle"] < std::numbers::pi),
        view_(p["half_angle"]),
        highest_{std::sin(p["highest"]), std::cos(p["highest"])},
        reach_(p["reach"]) {}

  /// Of the azimuth; elevations have ends.
  [[nodiscard]] double period(int row) const override {
    return row == 0 ? 2 * std::numbers::pi : 0;
  }

  template <class T>
  void read(const delos::Point<T>& p, delos::Reading<T, 2>& out) const {
    using std::abs, std::atan2, std::min, std::sqrt;
    // A length that has slopes at 0, too.
    const T level = sqrt(p.x * p.x + p.z * p.z + 1e-24 * squared_norm(p));
    out.z[0] = atan2(p.x, p.z);
    out.z[1] = atan2(T(-p.y), level);
    out.variance[0] = variance_[0];
    out.variance[1] = variance_[1];
    // |β| ≤ highest is two cones about y.
    out.inside = min(T(reach_ - sqrt(squared_norm(p))),
                     T(highest_[0] * level - highest_[1] * abs(p.y)));
    if (round_) out.inside = min(out.inside, view_.inside(p));
  }

 private:
  double variance_[2];  // rad²
  bool round_;          // it doesn't see all around
  delos::AxisCone view_;
  double highest_[2];  // sine and cosine of the highest elevation
  double reach_;       // m
};

}  // namespace

DELOS_DEVICE_PLUGIN(Goniometer, "goniometer", "1.0.0",
                    "Azimuth and elevation of a point, with constant angle noise.");
