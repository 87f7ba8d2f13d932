// A HiBall: photodiodes that look through each other's lenses at LEDs.
//
// view.h has their geometry.
//
// Sources: Welch et al. (2001), High-performance wide-area optical tracking: the HiBall
// tracking system, Presence 10(1); Allen (2007), Comparing the expected performance of
// tracking and motion capture systems, UNC Chapel Hill, §5.1.1 and ch. 7. The README
// says of every constant where it comes from.
#include <delos/device/beacon_device.h>
#include <delos/plugin.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "photodiode.h"
#include "view.h"

namespace {

using delos::choice, delos::matrix, delos::number;
using Eigen::Vector3d;

/// Axes at the tilt of a regular dodecahedron's faces, atan 2 from +z, and +z itself.
std::vector<Vector3d> dodecahedron_axes(int around) {
  std::vector<Vector3d> axes = {Vector3d::UnitZ()};
  for (int k = 0; k < around; ++k) {
    const double azimuth = 2 * std::numbers::pi * k / around;
    axes.push_back(
        Vector3d(2 * std::cos(azimuth), 2 * std::sin(azimuth), 1).normalized());
  }
  return axes;
}

std::vector<Vector3d> axes_of(const delos::ParamValues& p) {
  const std::string& layout = p.choice("layout");
  if (layout == "six") return dodecahedron_axes(5);
  if (layout == "four") return dodecahedron_axes(3);
  const Eigen::MatrixXd& rows = p.matrix("axes");
  if (rows.cols() != 3) {
    throw std::invalid_argument("axes must be rows of three numbers, [[x, y, z], …]");
  }
  std::vector<Vector3d> axes;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Vector3d axis = rows.row(i);
    if (axis.isZero(0)) {
      throw std::invalid_argument("axes: axis " + std::to_string(i) +
                                  " has length zero, which is no direction");
    }
    axes.push_back(axis.stableNormalized());
  }
  return axes;
}

class HiBall final : public delos::BeaconDevice<HiBall, hiball::View, 2> {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      choice("layout", "six|four|custom",
             "Photodiodes: one up and five or three around it at 63.4 degrees, or "
             "`axes`.")
          .initially("six"),
      matrix("axes", "Axes of a custom layout in the device's frame, [[x, y, z], …].")
          .initially("[[0, 0, 1]]"),
      choice("views", "primary|adjacent|all_pairs",
             "Lenses that a photodiode looks through: its own, those nearby too, or "
             "all.")
          .initially("adjacent"),
      number("adjacent_angle", "rad",
             "Greatest angle of axes that `views: adjacent` calls nearby.")
          .initially(1.117)
          .between(0, std::numbers::pi),
      number("focal", "m", "Distance from a lens to the photodiode opposite.")
          .initially(0.0382)
          .between(1e-4, 10)
          .by_factors(),
      number("field", "rad",
             "Field of view of a photodiode through its own lens, edge to edge.")
          .initially(0.104719755119659775)
          .between(1e-4, 3.1)
          .by_factors(),
      choice("noise", "constant|photodiode",
             "Whether the noise is the same everywhere or follows from the light.")
          .initially("constant"),
      number("r", "1",
             "Variance of u and of v, half-widths squared, for noise: constant.")
          .initially(2.1e-5)
          .at_least(1e-30)
          .by_factors(),
      number("light", "s", "How long the light of a sighting is integrated.")
          .initially(1e-4)
          .between(1e-7, 1)
          .by_factors(),
      choice("sum", "linear|independent",
             "How the noises of an axis's two ends add up; linear is the worst case.")
          .initially("linear"),
      choice("reading", "variance|published",
             "R is the square of the noise; or, as the published figures have it, the "
             "noise itself.")
          .initially("variance"),
      number("rf", "ohm", "Feedback resistance of the amplifiers.")
          .initially(2e5)
          .at_least(1),
      number("rie", "ohm", "Interelectrode resistance of the photodiode.")
          .initially(7500)
          .at_least(1),
      number("vn", "1", "Voltage noise of an amplifier, volts per root hertz.")
          .initially(4.5e-9)
          .at_least(0),
      number("in", "1", "Current noise of an amplifier, amperes per root hertz.")
          .initially(6e-13)
          .at_least(0),
      number("bandwidth", "1/s", "Bandwidth of the one-pole filter.")
          .initially(1.6e5)
          .at_least(1),
      number("gap", "s", "Time between the light and the dark window.")
          .initially(2e-5)
          .at_least(0),
      number("current", "A m^2", "Photocurrent of an LED one metre away, head on.")
          .initially(5.361239747e-6)
          .at_least(1e-30),
      number("temperature", "K", "Temperature of photodiode and amplifiers.")
          .initially(300)
          .at_least(1),
  };

  explicit HiBall(const delos::ParamValues& p)
      : focal_(p["focal"]),
        half_width_(p["focal"] * std::tan(p["field"] / 2)),
        constant_(p.choice("noise") == "constant"),
        r_(p["r"]),
        published_(p.choice("reading") == "published"),
        sum_(p.choice("sum") == "linear" ? hiball::Sum::linear
                                         : hiball::Sum::independent),
        diode_{.feedback = p["rf"],
               .interelectrode = p["rie"],
               .voltage_noise = p["vn"],
               .current_noise = p["in"],
               .bandwidth = p["bandwidth"],
               .temperature = p["temperature"],
               .current = p["current"],
               .gap = p["gap"]},
        gain_(hiball::window_gain(diode_, p["light"])) {
    const std::vector<Vector3d> axes = axes_of(p);
    check_apart(axes);
    const std::string& rule = p.choice("views");
    for (std::size_t i = 0; i < axes.size(); ++i) {
      for (std::size_t j = 0; j < axes.size(); ++j) {
        const bool nearby = hiball::angle(axes[i], axes[j]) <= p["adjacent_angle"];
        if (i == j || rule == "all_pairs" || (rule == "adjacent" && nearby)) {
          const auto view = hiball::view_of({axes[i], axes[j], focal_, half_width_});
          if (!view) continue;
          views_.push_back(*view);
          names_.push_back("photodiode " + std::to_string(i) + " through lens " +
                           std::to_string(j));
        }
      }
    }
  }

  [[nodiscard]] int views() const override { return static_cast<int>(views_.size()); }

  [[nodiscard]] delos::ViewCone view_cone(int view) const override {
    return views_[static_cast<std::size_t>(view)].cone;
  }

  [[nodiscard]] std::string view_name(int view) const override {
    return names_[static_cast<std::size_t>(view)];
  }

  [[nodiscard]] const hiball::View& opening(int view) const {
    return views_[static_cast<std::size_t>(view)];
  }

  template <class T>
  void read(const hiball::View& view, const delos::Point<T>& p,
            const delos::Point<double>& n, delos::Reading<T, 2>& out) const {
    const delos::Point<T> way = {view.lens_p.x() - p.x, view.lens_p.y() - p.y,
                                 view.lens_p.z() - p.z};
    hiball::project(view, way, out);
    const double facing = n.x * plain(way.x) + n.y * plain(way.y) + n.z * plain(way.z);
    out.inside = chosen(all_around(n) | (facing > 0), out.inside, T(-1));
  }

  void noise(const hiball::View& view, const delos::Point<double>& p,
             const delos::Point<double>& n, const double (&z)[2],
             double (&variance)[2]) const {
    if (constant_) {
      variance[0] = variance[1] = r_;
      return;
    }
    const Vector3d way = view.lens_p - Vector3d(p.x, p.y, p.z);
    const double distance = way.norm();
    const double cosine =
        all_around(n) ? 1.0 : Vector3d(n.x, n.y, n.z).dot(way) / distance;
    for (int i = 0; i < 2; ++i) {
      const double noise =
          hiball::position_noise(diode_, sum_, gain_, z[i], cosine, distance);
      variance[i] = published_ ? noise : noise * noise;
    }
  }

 private:
  static void check_apart(const std::vector<Vector3d>& axes) {
    for (std::size_t j = 0; j < axes.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        if (hiball::angle(axes[i], axes[j]) > 1e-6) continue;
        throw std::invalid_argument(
            "axes " + std::to_string(i) + " and " + std::to_string(j) +
            " are the same; two lenses can't stand in one place");
      }
    }
  }

  static bool all_around(const delos::Point<double>& n) {
    return (n.x == 0) & (n.y == 0) & (n.z == 0);
  }

  double focal_, half_width_;  // m
  bool constant_;
  double r_;  // half-widths squared
  bool published_;
  hiball::Sum sum_;
  hiball::Photodiode diode_;
  double gain_;
  std::vector<hiball::View> views_;
  std::vector<std::string> names_;
};

}  // namespace

DELOS_DEVICE_PLUGIN(HiBall, "hiball", "1.0.0",
                    "Photodiodes behind lenses that see LEDs: the HiBall and its kin.");
