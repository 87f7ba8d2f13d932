// A jointed arm whose tip is the target: encoders read its waist, shoulder and elbow.
// It stands at the device's origin, z up along its waist.
//
//   tip  ρ = l₁ cos s + l₂ cos(s + e),  z = l₁ sin s + l₂ sin(s + e)
//        (x, y) = ρ (cos a, sin a)
//
//   read  e = −acos c,  c = (ρ² + z² − l₁² − l₂²)/(2 l₁ l₂)        elbow up
//         s = atan2(z, ρ) − atan2(l₂ sin e, l₁ + l₂ cos e)
//         a = atan2(y, x)
//
//   R = σ² I,   σ given, or 2π/(counts √12) of encoders with so many steps a turn
//
// Reached where its elbow is bent by at least `straightest`, short of straight and of
// folded, and the tip is off the waist's axis by at least `nearest`.
// Sources: README.md.
#include <delos/device/point_device.h>
#include <delos/plugin.h>

#include <numbers>
#include <stdexcept>

namespace {

using delos::number;

class Linkage final : public delos::PointDevice<Linkage, 3> {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      number("upper", "m", "From its shoulder to its elbow.").between(1e-3, 100),
      number("fore", "m", "From its elbow to its tip.").between(1e-3, 100),
      number("sigma", "rad",
             "Standard deviation of a joint's angle; 0: `counts` says it.")
          .initially(0)
          .at_least(0),
      number("counts", "1", "Steps of an encoder a turn, whose width is the noise.")
          .initially(0)
          .at_least(0),
      number("straightest", "rad",
             "Least angle by which its elbow is off straight, and off folded.")
          .initially(0.3)
          .between(0.2, 1.5),
      number("nearest", "m", "Least distance of the tip from the waist's axis.")
          .initially(0.02)
          .at_least(1e-6),
  };

  explicit Linkage(const delos::ParamValues& p)
      : upper_(p["upper"]), fore_(p["fore"]), nearest_(p["nearest"]) {
    if ((p["sigma"] > 0) == (p["counts"] > 0))
      throw std::invalid_argument(
          "how well are angles read? give either sigma or counts");
    // A step's width, evenly distributed.
    const double sigma = p["sigma"] > 0
                             ? p["sigma"]
                             : 2 * std::numbers::pi / p["counts"] / std::sqrt(12.0);
    variance_ = sigma * sigma;
    const double bent = std::cos(p["straightest"]);
    farthest_ = reach_of(bent);
    closest_ = reach_of(-bent);
  }

  bool needs_sight() const override { return false; }
  /// Angles end where the arm does: searches take differences of what it reads.
  bool observe_smoothly(const Eigen::Vector3d&, delos::SmoothRows&) const override {
    return false;
  }

  /// Of waist and shoulder, which turn all around.
  [[nodiscard]] double period(int row) const override {
    return row < 2 ? 2 * std::numbers::pi : 0;
  }

  template <class T>
  void read(const delos::Point<T>& p, delos::Reading<T, 3>& out) const {
    using std::atan2, std::cos, std::max, std::min, std::sin, std::sqrt;
    const T square = squared_norm(p), distance = sqrt(square + kNothing);
    // Lengths that have slopes at 0, too.
    const T rho = sqrt(p.x * p.x + p.y * p.y + kNothing);
    const T c = (square - upper_ * upper_ - fore_ * fore_) / (2 * upper_ * fore_);
    const T e = -atan2(sqrt(max(T(1.0 - c * c), T(kNothing))), c);
    out.z[0] = atan2(p.y, p.x);
    out.z[1] = atan2(p.z, rho) - atan2(T(fore_ * sin(e)), T(upper_ + fore_ * cos(e)));
    out.z[2] = e;
    for (T& variance : out.variance) variance = variance_;
    out.inside =
        min(min(T(farthest_ - distance), T(distance - closest_)), T(rho - nearest_));
  }

 private:
  static constexpr double kNothing = 1e-24;

  /// The tip's distance from the shoulder where the elbow's cosine is so.
  [[nodiscard]] double reach_of(double cosine) const {
    return std::sqrt(upper_ * upper_ + fore_ * fore_ + 2 * upper_ * fore_ * cosine);
  }

  double upper_, fore_;        // m
  double nearest_;             // m
  double variance_;            // rad²
  double farthest_, closest_;  // of the tip from the shoulder, m
};

}  // namespace

DELOS_DEVICE_PLUGIN(Linkage, "linkage", "1.0.0",
                    "Jointed arm that holds the target: encoders of three joints.");
