// A camera that sees a point: where it lies on the image, in normalised coordinates.
//
//   u = x/z + v_u,   v = y/z + v_v      x right, y down, z forward along the optical
//   axis
//
//   noise: pixels     R = (sigma pitch / focal)² I     centroiding, the same anywhere
//   noise: distance   R = r d² I,  d = ‖(x, y, z)‖     signal that fades with distance
//
// Seen where near ≤ z ≤ far, |u| ≤ w pitch / (2 focal) and |v| ≤ h pitch / (2 focal).
// Source: Allen & Welch (2005), "A general method for comparing the expected
// performance of tracking and motion capture systems", VRST '05, §3.3.
#include <delos/device/point_device.h>
#include <delos/plugin.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace {

using delos::choice, delos::number, delos::vector;

class PinholeCamera final : public delos::PointDevice<PinholeCamera, 2> {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      number("focal", "m", "Focal length of the lens.").between(1e-4, 10).by_factors(),
      number("pitch", "m", "Width of a pixel, which is square.")
          .between(1e-7, 1e-3)
          .by_factors(),
      vector("resolution", "px", 2, "Width and height of the image.").at_least(1),
      number("near", "m", "Least depth along the optical axis that is seen.")
          .initially(0.05)
          .at_least(1e-6),
      number("far", "m", "Greatest depth along the optical axis that is seen.")
          .initially(100)
          .at_least(1e-6),
      choice("noise", "pixels|distance",
             "Whether the noise is constant on the image or grows with distance.")
          .initially("pixels"),
      number("sigma", "px",
             "Standard deviation of a coordinate of a centroid, for noise: pixels.")
          .initially(0.1)
          .at_least(0),
      number("r", "1/m^2",
             "Variance of u and of v at one metre, for noise: distance; 0 is perfect.")
          .initially(0)
          .at_least(0),
  };

  explicit PinholeCamera(const delos::ParamValues& p)
      : near_(p["near"]), far_(p["far"]), pixel_(p["pitch"] / p["focal"]) {
    const double pixel = pixel_;
    const Eigen::MatrixXd& resolution = p.matrix("resolution");
    if (near_ >= far_) throw std::invalid_argument("near must be less than far");
    if (resolution.size() != 2 || !(resolution.array() > 0).all()) {
      throw std::invalid_argument("resolution must be a width and a height above 0");
    }
    u_max_ = resolution(0) * pixel / 2;
    v_max_ = resolution(1) * pixel / 2;
    least_cosine_ = 0.7 / std::sqrt(1 + u_max_ * u_max_ + v_max_ * v_max_);
    u_cosine_ = 1 / std::hypot(u_max_, 1);
    v_cosine_ = 1 / std::hypot(v_max_, 1);
    if (p.choice("noise") == "pixels") {
      constant_ = p["sigma"] * pixel * p["sigma"] * pixel;
    } else {
      growing_ = p["r"];
    }
  }

  // What a pixel covers of a plane that faces the camera: pitch/focal at a depth of 1.
  double footprint(const Eigen::Vector3d& p) const override { return pixel_ * p.z(); }

  // How far the point is from the nearest plane of the frustum. The sides pass through
  // the origin: u ≤ u_max where (u_max z − x) cos(atan u_max) ≥ 0.
  template <class T>
  void read(const delos::Point<T>& p, delos::Reading<T, 2>& out) const {
    out.z[0] = p.x / p.z;
    out.z[1] = p.y / p.z;
    out.variance[0] = out.variance[1] = constant_ + growing_ * squared_norm(p);
    using std::abs, std::min;
    const T side_u = u_cosine_ * (u_max_ * p.z - abs(p.x));
    const T side_v = v_cosine_ * (v_max_ * p.z - abs(p.y));
    out.inside = min(min(T(p.z - near_), T(far_ - p.z)), min(side_u, side_v));
  }

  // Beyond the edge of the image depth is kept from vanishing, at z/d = c inside of
  // which all that is in view lies (d the distance):
  //
  //   depth = z where z ≥ c d,  else c d (1 + exp(2 (z/(c d) − 1)))/2
  //
  // The margin is that of the nearest plane of the frustum, as the sine of an angle at
  // the camera. By hand, since searches ask it most: a gradient takes half the time.
  bool observe_smoothly(const Eigen::Vector3d& p,
                        delos::SmoothRows& out) const override {
    const double d = p.norm();
    if (d == 0 || constant_ + growing_ == 0) return false;
    const Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();
    const double least = least_cosine_ * d;
    double depth = p.z();
    Eigen::Vector3d depth_slope = forward;
    if (p.z() < least) {
      const double decay = std::exp(2 * (p.z() / least - 1));
      depth = least * (1 + decay) / 2;
      depth_slope = decay * forward +
                    least_cosine_ * ((1 + decay) / 2 - decay * p.z() / least) * p / d;
    }
    out.rows = 2;
    out.H.topRows<2>() << 1 / depth, 0, -p.x() / (depth * depth),  //
        0, 1 / depth, -p.y() / (depth * depth);
    for (int k = 0; k < 3; ++k) {
      const double s = -depth_slope(k) / (depth * depth);  // of 1/depth
      const double x = (k == 0 ? -1 / depth : 0) / depth - 2 * p.x() * s / depth;
      const double y = (k == 1 ? -1 / depth : 0) / depth - 2 * p.y() * s / depth;
      out.H_slope[k].topRows<2>() << s, 0, x,  //
          0, s, y;
    }
    out.variance.head<2>().setConstant(constant_ + growing_ * d * d);
    out.variance_slope.row(0) = out.variance_slope.row(1) =
        2 * growing_ * p.transpose();

    // A plane a·p + b ≥ 0 has the margin (a·p + b)/d.
    const auto plane = [&](const Eigen::Vector3d& a, double b, bool first) {
      const double margin = (a.dot(p) + b) / d;
      if (!first && margin >= out.margin) return;
      out.margin = margin;
      out.margin_slope = (a - margin * p / d) / d;
    };
    plane(forward, -near_, true);
    plane(-forward, far_, false);
    plane({std::copysign(u_cosine_, -p.x()), 0, u_cosine_ * u_max_}, 0, false);
    plane({0, std::copysign(v_cosine_, -p.y()), v_cosine_ * v_max_}, 0, false);
    return true;
  }

 private:
  double near_, far_;           // m
  double pixel_;                // its width, normalised
  double u_max_, v_max_;        // half the image, normalised
  double u_cosine_, v_cosine_;  // of the angles to its edges
  double least_cosine_;  // of the angle to the axis beyond which depth is smoothed
  double constant_ = 0;  // normalised, squared
  double growing_ = 0;   // normalised, squared, 1/m²
};

}  // namespace

DELOS_DEVICE_PLUGIN(PinholeCamera, "pinhole_camera", "1.0.0",
                    "Camera with a pinhole lens that sees points on its image.");
