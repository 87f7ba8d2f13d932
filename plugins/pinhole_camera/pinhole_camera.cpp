// A camera that sees a point: where it lies on the image, in normalised coordinates.
//
//   u = x/z + v_u,   v = y/z + v_v      x right, y down, z forward along the optical
//   axis
//
//   ∂(u, v)/∂(x, y, z) = 1/z ⎡ 1  0  −u ⎤
//                            ⎣ 0  1  −v ⎦
//
//   noise: pixels     R = (sigma pitch / focal)² I     centroiding, the same anywhere
//   noise: distance   R = r d² I,  d = ‖(x, y, z)‖     signal that fades with distance
//
// Seen where near ≤ z ≤ far, |u| ≤ w pitch / (2 focal) and |v| ≤ h pitch / (2 focal).
// Source: Allen & Welch (2005), "A general method for comparing the expected
// performance of tracking and motion capture systems", VRST '05, §3.3.
#include <delos/plugin.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace {

class PinholeCamera final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      {.name = "focal",
       .unit = "m",
       .lower = 1e-4,
       .upper = 10,
       .scale = delos::ParamScale::log,
       .help = "Focal length of the lens."},
      {.name = "pitch",
       .unit = "m",
       .lower = 1e-7,
       .upper = 1e-3,
       .scale = delos::ParamScale::log,
       .help = "Width of a pixel, which is square."},
      {.name = "resolution",
       .kind = delos::ParamKind::vector,
       .unit = "px",
       .lower = 1,
       .length = 2,
       .help = "Width and height of the image."},
      {.name = "near",
       .unit = "m",
       .initial = 0.05,
       .lower = 1e-6,
       .help = "Least depth along the optical axis that is seen."},
      {.name = "far",
       .unit = "m",
       .initial = 100,
       .lower = 1e-6,
       .help = "Greatest depth along the optical axis that is seen."},
      {.name = "noise",
       .kind = delos::ParamKind::choice,
       .text = "pixels",
       .choices = "pixels|distance",
       .help = "Whether the noise is constant on the image or grows with distance."},
      {.name = "sigma",
       .unit = "px",
       .initial = 0.1,
       .lower = 0,
       .help = "Standard deviation of a coordinate of a centroid, for noise: pixels."},
      {.name = "r",
       .unit = "1/m^2",
       .initial = 0,
       .lower = 0,
       .help =
           "Variance of u and of v at one metre, for noise: distance; 0 is perfect."},
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
    u_plane_ = {1 / std::hypot(u_max_, 1), u_max_ / std::hypot(u_max_, 1)};
    v_plane_ = {1 / std::hypot(v_max_, 1), v_max_ / std::hypot(v_max_, 1)};
    if (p.choice("noise") == "pixels") {
      constant_ = p["sigma"] * pixel * p["sigma"] * pixel;
    } else {
      growing_ = p["r"];
    }
  }

  // What a pixel covers of a plane that faces the camera: pitch/focal at a depth of 1.
  double footprint(const Eigen::Vector3d& p) const override { return pixel_ * p.z(); }

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    const double z = target.p_ST.z();
    if (!(z >= near_ && z <= far_)) return false;
    const double u = target.p_ST.x() / z;
    const double v = target.p_ST.y() / z;
    if (std::abs(u) > u_max_ || std::abs(v) > v_max_) return false;

    out.z.resize(2);
    out.z << u, v;
    out.H.resize(2, 3);
    out.H << 1 / z, 0, -u / z,  //
        0, 1 / z, -v / z;
    const double variance = constant_ + growing_ * target.p_ST.squaredNorm();
    out.R.resize(2, 2);
    out.R << variance, 0,  //
        0, variance;
    return true;
  }

  bool observe_lanes(const delos::PointLanes& points,
                     delos::RowLanes& out) const override {
    out.rows = 2;
    for (int l = 0; l < delos::kLanes; ++l) {
      const double x = points.p[0][l], y = points.p[1][l], z = points.p[2][l];
      const double u = x / z, v = y / z;
      const bool seen = (z >= near_) & (z <= far_) & (std::abs(u) <= u_max_) &
                        (std::abs(v) <= v_max_);
      out.seen[l] = seen ? 1 : 0;
      out.H[0][0][l] = out.H[1][1][l] = 1 / z;
      out.H[0][1][l] = out.H[1][0][l] = 0;
      out.H[0][2][l] = -u / z;
      out.H[1][2][l] = -v / z;
      out.variance[0][l] = out.variance[1][l] =
          constant_ + growing_ * (x * x + y * y + z * z);
    }
    return true;
  }

  // Beyond the edge of the image depth is kept from vanishing, at z/d = c inside of
  // which all that is in view lies (d the distance):
  //
  //   depth = z where z ≥ c d,  else c d (1 + exp(2 (z/(c d) − 1)))/2
  //
  // The margin is that of the nearest plane of the frustum, as the sine of an angle at
  // the camera.
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
    plane({std::copysign(u_plane_.x(), -p.x()), 0, u_plane_.y()}, 0, false);
    plane({0, std::copysign(v_plane_.x(), -p.y()), v_plane_.y()}, 0, false);
    return true;
  }

  // The frustum is convex: a ball is inside where it is on the inner side of all six
  // planes, and outside where it is beyond one of them. The sides pass through the
  // origin: u ≤ u_max where u_max z − x ≥ 0.
  delos::View view_of_ball(const Eigen::Vector3d& center,
                           double radius) const override {
    const double x = std::abs(center.x()), y = std::abs(center.y()), z = center.z();
    const double depth = std::min(z - near_, far_ - z);
    const double side_u = u_plane_.y() * z - u_plane_.x() * x;
    const double side_v = v_plane_.y() * z - v_plane_.x() * y;
    const double inner = std::min({depth, side_u, side_v});
    // Rounding may not turn a touch into a certainty.
    const double sure = radius + 1e-9 * (center.norm() + far_);
    if (inner < -sure) return delos::View::outside;
    return inner > sure ? delos::View::inside : delos::View::crossing;
  }

 private:
  double near_, far_;                  // m
  double pixel_;                       // its width, normalised
  double u_max_, v_max_;               // half the image, normalised
  Eigen::Vector2d u_plane_, v_plane_;  // the sides' normals: across, and forward
  double least_cosine_;  // of the angle to the axis beyond which depth is smoothed
  double constant_ = 0;  // normalised, squared
  double growing_ = 0;   // normalised, squared, 1/m²
};

}  // namespace

DELOS_DEVICE_PLUGIN(PinholeCamera, "pinhole_camera", "1.0.0",
                    "Camera with a pinhole lens that sees points on its image.");
