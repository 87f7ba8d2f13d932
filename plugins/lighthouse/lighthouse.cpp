// A base station whose rotors sweep planes of light over photodiodes on the target: two
// angles of each, of constant noise. x right, y down, z forward.
//
//   v1: two rotors     α₁ = atan2(x, z),  α₂ = atan2(y, z)
//   v2: one rotor with two planes, tilted by ±t out of its axis y
//                      α = atan2(x, z) ± asin(y tan t/ρ),   ρ = √(x² + z²)
//
//   R = sigma² I, of which the part `common` is the same for all photodiodes that one
//   sweep hits: the rotor's jitter.
//
// Sources: README.md.
#include <delos/device/axis_cone.h>
#include <delos/device/point_device.h>
#include <delos/plugin.h>

#include <numbers>

namespace {

using delos::choice, delos::number;

class Lighthouse final : public delos::PointDevice<Lighthouse, 2> {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      choice("generation", "v1|v2", "Two rotors, or one with two tilted planes.")
          .initially("v2"),
      number("sigma", "rad", "Standard deviation of the angle of a sweep.")
          .initially(35e-6)
          .at_least(0),
      number("common", "1",
             "The part of its variance that all photodiodes on the target share.")
          .initially(0.75)
          .between(0, 0.999),
      number("tilt", "rad", "Of the planes out of the rotor's axis, of v2.")
          .initially(std::numbers::pi / 6)
          .between(0.01, 1.5),
      number("across", "rad", "Angle that is swept across.")
          .initially(2 * std::numbers::pi / 3)
          .between(0.01, 3),
      number("down", "rad", "Angle that is swept from top to bottom.")
          .initially(11 * std::numbers::pi / 18)
          .between(0.01, 3),
      number("reach", "m", "Farthest photodiode that is hit.")
          .initially(10)
          .at_least(1e-3),
  };

  explicit Lighthouse(const delos::ParamValues& p)
      : tilted_(p.choice("generation") == "v2"),
        variance_(p["sigma"] * p["sigma"]),
        common_(p["common"]),
        slope_(std::tan(p["tilt"])),
        across_{std::sin(p["across"] / 2), std::cos(p["across"] / 2)},
        down_{std::sin(p["down"] / 2), std::cos(p["down"] / 2)},
        reach_(p["reach"]) {
    // Of (y tan t)² ≤ ρ² at the edges of the view, over d².
    const double left = down_[1] * down_[1] - std::pow(down_[0] * slope_, 2);
    if (tilted_ && !(left > 0))
      throw std::invalid_argument(
          "tilt and half of 'down' together must be below 90 deg: a tilted plane never "
          "reaches farther");
    least_ = left / 2;
    least_cosine_ = 0.7 * across_[1] * down_[1];
  }

  Eigen::Vector3d shared_variance() const override {
    return {common_ * variance_, common_ * variance_, 0};
  }

  template <class T>
  void read(const delos::Point<T>& p, delos::Reading<T, 2>& out) const {
    using std::abs, std::atan2, std::min, std::sqrt;
    const T turn = atan2(p.x, soft_depth(p, least_cosine_));
    if (tilted_) {
      // asin(y tan t/ρ) as atan2(y tan t, √(ρ² − (y tan t)²)).
      const T rise = slope_ * p.y;
      const T square = p.x * p.x + p.z * p.z - rise * rise;
      const T lean = atan2(rise, sqrt(above_zero(square, p)));
      out.z[0] = turn + lean;
      out.z[1] = turn - lean;
    } else {
      out.z[0] = turn;
      out.z[1] = atan2(p.y, soft_depth(p, least_cosine_));
    }
    out.variance[0] = out.variance[1] = variance_;
    // Planes through the rotor's axis, and cones about it.
    const T level = sqrt(p.x * p.x + p.z * p.z + 1e-24 * squared_norm(p));
    const T sides = min(T(across_[0] * p.z - across_[1] * abs(p.x)),
                        T(down_[0] * level - down_[1] * abs(p.y)));
    out.inside = min(T(reach_ - sqrt(squared_norm(p))), sides);
  }

 private:
  // Beyond the view a plane may never pass: there, below ε d², the square s goes on as
  // ε d² exp(s/(ε d²) − 1).
  template <class T>
  [[nodiscard]] T above_zero(const T& square, const delos::Point<T>& p) const {
    using std::exp;
    const T least = least_ * squared_norm(p);
    return delos::plain(square) > delos::plain(least)
               ? square
               : least * exp(square / least - 1.0);
  }

  bool tilted_;
  double variance_, common_;    // rad²; of it
  double slope_;                // of a plane to the axis
  double across_[2], down_[2];  // sine and cosine of half the angles swept
  double least_;                // ε
  double least_cosine_;         // of the angle to z beyond which depth is smoothed
  double reach_;                // m
};

}  // namespace

DELOS_DEVICE_PLUGIN(Lighthouse, "lighthouse", "1.0.0",
                    "Base station that sweeps two planes of light over the target.");
