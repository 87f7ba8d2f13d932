// The direction of a point about one axis, and no more: a turning detector, an antenna
// array, a direction finder.
//
//   z = atan2(y, x) + v,   v ~ N(0, sigma²),   ∂z/∂p = [−y, x, 0]/ρ²,   ρ² = x² + y²
//
// p is the point in the device's frame, whose z axis the angle is about and whose x
// axis it is counted from. Its noise is one of the angle, the same everywhere: what a
// range ρ makes of it is ρ sigma across the line of sight. Source: README.md.
#include <delos/device/point_device.h>
#include <delos/plugin.h>

#include <numbers>

namespace {

using delos::number;
constexpr double kPi = std::numbers::pi;

class Bearing final : public delos::PointDevice<Bearing, 1> {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      number("sigma", "rad", "Standard deviation of the angle.")
          .between(1e-9, kPi)
          .by_factors(),
      number("field", "rad",
             "Whole angle about the x axis in which it sees; 360 deg: "
             "all around.")
          .initially(2 * kPi)
          .between(1e-3, 2 * kPi),
      number("elevation", "rad", "Greatest angle out of its plane that it sees.")
          .initially(80 * kPi / 180)
          .between(1e-3, 89.9 * kPi / 180),
      number("reach", "m", "Farthest point that is seen.").initially(100).at_least(0),
  };

  explicit Bearing(const delos::ParamValues& p)
      : variance_(p["sigma"] * p["sigma"]),
        half_field_(p["field"] / 2),
        sine_(std::sin(half_field_)),
        cosine_(std::cos(half_field_)),
        rise_(std::sin(p["elevation"])),
        run_(std::cos(p["elevation"])),
        reach_(p["reach"]) {}

  template <class T>
  void read(const delos::Point<T>& p, delos::Reading<T, 1>& out) const {
    using std::abs, std::atan2, std::min, std::sqrt;
    // On the axis ρ would have no slope.
    const T rho = sqrt(p.x * p.x + p.y * p.y + kNothing);
    out.z[0] = atan2(p.y, p.x);
    out.variance[0] = variance_;
    // Distances to the edges of the view.
    out.inside =
        min(T(reach_ - sqrt(squared_norm(p))), T(rho * rise_ - abs(p.z) * run_));
    if (half_field_ < kPi)
      out.inside = min(out.inside, T(p.x * sine_ - abs(p.y) * cosine_));
  }

  [[nodiscard]] double period(int) const override { return 2 * kPi; }

  /// About the x axis, or all around.
  [[nodiscard]] delos::ViewCone view_cone(int) const override {
    // The corner of the view is where field and elevation end together.
    const double corner = std::acos(cosine_ * run_) + 1e-9;
    return {.axis = Eigen::Vector3d::UnitX(),
            .half_angle = half_field_ < kPi / 2 ? corner : 3.15,
            .range = reach_ * (1 + 1e-12)};
  }

  /// In view as read() has it. Beyond the elevation ρ² goes on as z² cot²(elevation),
  /// so that nothing is infinite on the axis.
  [[nodiscard]] bool observe_smoothly(const Eigen::Vector3d& at,
                                      delos::SmoothRows& out) const override {
    using T = delos::FirstOrder;
    if (at.isZero(0)) return false;
    const delos::Point<T> p = delos::independent(at.x(), at.y(), at.z());
    delos::Reading<T, 1> reading;
    read(p, reading);
    const T margin = reading.inside / sqrt(squared_norm(p));
    const double steep = run_ / rise_;
    const T square = max(p.x * p.x + p.y * p.y, p.z * p.z * (steep * steep));
    const T h[3] = {-p.y / square, p.x / square, T(0)};
    out.rows = 1;
    out.margin = margin.value;
    out.variance(0) = variance_;
    out.variance_slope.row(0).setZero();
    for (int k = 0; k < 3; ++k) {
      out.margin_slope(k) = margin.slope[k];
      out.H(0, k) = h[k].value;
      for (int i = 0; i < 3; ++i) out.H_slope[k](0, i) = h[i].slope[k];
    }
    return true;
  }

 private:
  static constexpr double kNothing = 1e-24;  // m²

  double variance_;       // rad²
  double half_field_;     // rad
  double sine_, cosine_;  // of half_field_
  double rise_, run_;     // sine and cosine of the elevation
  double reach_;          // m
};

}  // namespace

DELOS_DEVICE_PLUGIN(Bearing, "bearing", "1.0.0",
                    "Direction of a point about one axis, with noise of the angle.");
