// A HiBall: photodiodes that look through each other's lenses at LEDs.
//
// view.h has their geometry.
//
// Sources: Welch et al. (2001), High-performance wide-area optical tracking: the HiBall
// tracking system, Presence 10(1); Allen (2007), Comparing the expected performance of
// tracking and motion capture systems, UNC Chapel Hill, §5.1.1 and ch. 7. The README
// says of every constant where it comes from.
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

class HiBall final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      {.name = "layout",
       .kind = delos::ParamKind::choice,
       .text = "six",
       .choices = "six|four|custom",
       .help = "Photodiodes: one up and five or three around it at 63.4 degrees, or "
               "`axes`."},
      {.name = "axes",
       .kind = delos::ParamKind::matrix,
       .text = "[[0, 0, 1]]",
       .help = "Axes of a custom layout in the device's frame, [[x, y, z], …]."},
      {.name = "views",
       .kind = delos::ParamKind::choice,
       .text = "adjacent",
       .choices = "primary|adjacent|all_pairs",
       .help = "Lenses that a photodiode looks through: its own, those nearby too, or "
               "all."},
      {.name = "adjacent_angle",
       .unit = "rad",
       .initial = 1.117,
       .lower = 0,
       .upper = std::numbers::pi,
       .help = "Greatest angle of axes that `views: adjacent` calls nearby."},
      {.name = "focal",
       .unit = "m",
       .initial = 0.0382,
       .lower = 1e-4,
       .upper = 10,
       .scale = delos::ParamScale::log,
       .help = "Distance from a lens to the photodiode opposite."},
      {.name = "field",
       .unit = "rad",
       .initial = 0.104719755119659775,
       .lower = 1e-4,
       .upper = 3.1,
       .scale = delos::ParamScale::log,
       .help = "Field of view of a photodiode through its own lens, edge to edge."},
      {.name = "noise",
       .kind = delos::ParamKind::choice,
       .text = "constant",
       .choices = "constant|photodiode",
       .help = "Whether the noise is the same everywhere or follows from the light."},
      {.name = "r",
       .unit = "1",
       .initial = 2.1e-5,
       .lower = 1e-30,
       .scale = delos::ParamScale::log,
       .help = "Variance of u and of v, half-widths squared, for noise: constant."},
      {.name = "light",
       .unit = "s",
       .initial = 1e-4,
       .lower = 1e-7,
       .upper = 1,
       .scale = delos::ParamScale::log,
       .help = "How long the light of a sighting is integrated."},
      {.name = "sum",
       .kind = delos::ParamKind::choice,
       .text = "linear",
       .choices = "linear|independent",
       .help =
           "How the noises of an axis's two ends add up; linear is the worst case."},
      {.name = "reading",
       .kind = delos::ParamKind::choice,
       .text = "variance",
       .choices = "variance|published",
       .help =
           "R is the square of the noise; or, as the published figures have it, the "
           "noise itself."},
      {.name = "rf",
       .unit = "ohm",
       .initial = 2e5,
       .lower = 1,
       .help = "Feedback resistance of the amplifiers."},
      {.name = "rie",
       .unit = "ohm",
       .initial = 7500,
       .lower = 1,
       .help = "Interelectrode resistance of the photodiode."},
      {.name = "vn",
       .initial = 4.5e-9,
       .lower = 0,
       .help = "Voltage noise of an amplifier, volts per root hertz."},
      {.name = "in",
       .initial = 6e-13,
       .lower = 0,
       .help = "Current noise of an amplifier, amperes per root hertz."},
      {.name = "bandwidth",
       .unit = "1/s",
       .initial = 1.6e5,
       .lower = 1,
       .help = "Bandwidth of the one-pole filter."},
      {.name = "gap",
       .unit = "s",
       .initial = 2e-5,
       .lower = 0,
       .help = "Time between the light and the dark window."},
      {.name = "current",
       .unit = "A m^2",
       .initial = 5.361239747e-6,
       .lower = 1e-30,
       .help = "Photocurrent of an LED one metre away, head on."},
      {.name = "temperature",
       .unit = "K",
       .initial = 300,
       .lower = 1,
       .help = "Temperature of photodiode and amplifiers."},
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

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    for (int view = 0; view < views(); ++view) {
      if (observe_view(view, target, out)) return true;
    }
    return false;
  }

  bool observe_view(int view, const delos::Target& target,
                    delos::Observation& out) const override {
    const hiball::View& w = views_[static_cast<std::size_t>(view)];
    const Vector3d way = w.lens_p - target.p_ST;  // c − p, from the LED to the lens
    const hiball::Spot spot = hiball::project(w, way.x(), way.y(), way.z());
    if (!spot.seen) return false;
    const bool all_around = target.n_ST.isZero(0);
    if (!all_around && !(target.n_ST.dot(way) > 0)) return false;
    out.z.resize(2);
    out.z << spot.u, spot.v;
    out.H.resize(2, 3);
    for (int i = 0; i < 3; ++i) {
      out.H(0, i) = spot.scale * (w.e_u(i) + spot.lean_u * w.n(i));
      out.H(1, i) = spot.scale * (w.e_v(i) + spot.lean_v * w.n(i));
    }
    out.R.setZero(2, 2);
    if (constant_) {
      out.R.diagonal().setConstant(r_);
      return true;
    }
    const double distance = way.norm();
    const double cosine = all_around ? 1.0 : target.n_ST.dot(way) / distance;
    out.R(0, 0) = variance(spot.u, cosine, distance);
    out.R(1, 1) = variance(spot.v, cosine, distance);
    return true;
  }

  bool observe_view_lanes(int view, const delos::BeaconLanes& beacons,
                          delos::RowLanes& out) const override {
    const hiball::View w = views_[static_cast<std::size_t>(view)];
    const auto &p = beacons.p, &n = beacons.n;
    double u[delos::kLanes], v[delos::kLanes];
    out.rows = 2;
    for (int l = 0; l < beacons.count; ++l) {
      const double x = w.lens_p.x() - p[0][l], y = w.lens_p.y() - p[1][l],
                   z = w.lens_p.z() - p[2][l];
      const hiball::Spot spot = hiball::project(w, x, y, z);
      const double facing = n[0][l] * x + n[1][l] * y + n[2][l] * z;
      const bool all_around = (n[0][l] == 0) & (n[1][l] == 0) & (n[2][l] == 0);
      out.seen[l] = (spot.seen & (all_around | (facing > 0))) ? 1.0 : 0.0;
      for (int i = 0; i < 3; ++i) {
        out.H[0][i][l] = spot.scale * (w.e_u(i) + spot.lean_u * w.n(i));
        out.H[1][i][l] = spot.scale * (w.e_v(i) + spot.lean_v * w.n(i));
      }
      u[l] = spot.u, v[l] = spot.v;
      out.variance[0][l] = out.variance[1][l] = r_;
    }
    if (constant_) return true;
    for (int l = 0; l < beacons.count; ++l) {
      if (out.seen[l] == 0) continue;
      const Vector3d way = w.lens_p - Vector3d(p[0][l], p[1][l], p[2][l]);
      const Vector3d normal(n[0][l], n[1][l], n[2][l]);
      const double distance = way.norm();
      const double cosine = normal.isZero(0) ? 1.0 : normal.dot(way) / distance;
      out.variance[0][l] = variance(u[l], cosine, distance);
      out.variance[1][l] = variance(v[l], cosine, distance);
    }
    return true;
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

  [[nodiscard]] double variance(double x, double cosine, double distance) const {
    const double noise =
        hiball::position_noise(diode_, sum_, gain_, x, cosine, distance);
    return published_ ? noise : noise * noise;
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
