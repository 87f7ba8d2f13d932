// Where a calibrated camera sees a point on its image, and which points it sees.
//
// A lens turns the ray to (x, y, z), ρ = √(x² + y²), by its model into (a′, b′), and
// the image, in pixels from its upper left corner, is
//
//   u = f_x a′ + c_x,   v = f_y b′ + c_y
//
//   brown_conrady   a = x/z, b = y/z, s = a² + b², g = 1 + k1 s + k2 s² + k3 s³
//                   a′ = a g + 2 p1 a b + p2 (s + 2 a²)
//                   b′ = b g + 2 p2 a b + p1 (s + 2 b²)
//   rational        the same with g / (1 + k4 s + k5 s² + k6 s³) in g's place
//   fisheye         θ = atan2(ρ, z), θ′ = θ (1 + k1 θ² + k2 θ⁴ + k3 θ⁶ + k4 θ⁸)
//                   (a′, b′) = θ′ (x, y)/ρ
//
// Sources: Brown (1966), "Decentering distortion of lenses", Photogrammetric
// Engineering 32, with the coefficients' order and signs of OpenCV's calib3d; Kannala,
// Brandt (2006), "A generic camera model …", IEEE PAMI 28(8), Eq. 6, normalised as
// OpenCV's fisheye module has it.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <type_traits>

#include "delos/device/axis_cone.h"
#include "delos/device/camera_table.h"
#include "delos/device/parameters.h"
#include "delos/device/reading.h"

namespace delos {

/// A camera's lens and image, made of a plugin's parameters, which have the rows of
/// CameraTable.
class CameraModel {
 public:
  /// @throws std::invalid_argument the values clash
  explicit CameraModel(const ParamValues& p)
      : fisheye_(p.choice("distortion") == "fisheye"),
        rational_(p.choice("distortion") == "rational"),
        near_(p["near"]),
        far_(p["far"]),
        k_{p["k1"], p["k2"], p["k3"], p["k4"], p["k5"], p["k6"]},
        p_{p["p1"], p["p2"]} {
    const Eigen::MatrixXd& size = p.matrix("resolution");
    if (size.size() != 2 || !(size.array() > 0).all())
      throw std::invalid_argument("resolution must be a width and a height above 0");
    if (near_ >= far_) throw std::invalid_argument("near must be less than far");
    if (fisheye_ && (p_[0] != 0 || p_[1] != 0))
      throw std::invalid_argument(
          "p1 and p2 are of distortion: brown_conrady or rational");
    if (!fisheye_ && !rational_ && k_[3] != 0)
      throw std::invalid_argument("k4 is of distortion: fisheye or rational");
    if (!rational_ && (k_[4] != 0 || k_[5] != 0))
      throw std::invalid_argument("k5 and k6 are of distortion: rational");
    set_focal(p, size(0));
    left_ = -(p["c_x"] == 0 ? size(0) / 2 : p["c_x"]) / f_[0];
    right_ = left_ + size(0) / f_[0];
    up_ = -(p["c_y"] == 0 ? size(1) / 2 : p["c_y"]) / f_[1];
    down_ = up_ + size(1) / f_[1];
    centre_[0] = -left_ * f_[0];
    centre_[1] = -up_ * f_[1];
    bends_ = fisheye_ || p_[0] != 0 || p_[1] != 0 ||
             std::any_of(k_, k_ + 6, [](double k) { return k != 0; });
    set_view(p["half_angle"]);
  }

  [[nodiscard]] bool fisheye() const { return fisheye_; }
  /// Focal lengths, pixels.
  [[nodiscard]] double f_across() const { return f_[0]; }
  [[nodiscard]] double f_down() const { return f_[1]; }
  /// Width and height of the image, pixels.
  [[nodiscard]] double width() const { return (right_ - left_) * f_[0]; }
  [[nodiscard]] double height() const { return (down_ - up_) * f_[1]; }
  /// What near and far are about: depth, or a fisheye's distance.
  template <class T>
  [[nodiscard]] T reach(const Point<T>& p) const {
    if (!fisheye_) return p.z;
    using std::sqrt;
    return sqrt(squared_norm(p));
  }

  /// Nothing farther than this is seen.
  void limit_far(double metres) { far_ = std::min(far_, metres); }

  /// Where the point is on the image, pixels, and how far inside the view: at least 0
  /// where it is seen. Of a lens that doesn't bend in metres, as PointDevice has it;
  /// else bound the view by view_of_ball() below.
  template <class T>
  void look(const Point<T>& p, T& u, T& v, T& inside) const {
    using std::min;
    T a, b;
    bend(p, a, b);
    u = f_[0] * a + centre_[0];
    v = f_[1] * b + centre_[1];
    const T far_off = reach(p);
    inside = min(T(far_off - near_), T(far_ - far_off));
    if (bends_) {
      const T scale = fisheye_ ? far_off : depth(p);
      inside = min(inside, scale * min(min(T(a - left_), T(right_ - a)),
                                       min(T(b - up_), T(down_ - b))));
    } else {
      // A side passes through the origin: a ≥ left where (x − left z) cos(atan left) ≥
      // 0.
      const T across = min(T(cosine_[0] * (p.x - left_ * p.z)),
                           T(cosine_[1] * (right_ * p.z - p.x)));
      const T along =
          min(T(cosine_[2] * (p.y - up_ * p.z)), T(cosine_[3] * (down_ * p.z - p.y)));
      inside = min(inside, min(across, along));
    }
    if (bounded_) inside = min(inside, limit_.inside(p));
  }

  /// The depth of a point, above 0 where searches ask beyond the view, too.
  template <class T>
  [[nodiscard]] T depth(const Point<T>& p) const {
    return soft_depth(p, least_cosine_);
  }

  /// What a pixel covers across the sight line, metres: 1/the smaller singular value of
  /// ∂(u, v)/∂p, of the direction that gets fewest pixels.
  [[nodiscard]] double footprint(const Eigen::Vector3d& p) const {
    FirstOrder image[2], inside;
    look(independent(p.x(), p.y(), p.z()), image[0], image[1], inside);
    const Eigen::Map<const Eigen::Vector3d> u(image[0].slope), v(image[1].slope);
    const double uu = u.squaredNorm(), vv = v.squaredNorm();
    return 1 / std::sqrt((uu + vv - std::hypot(uu - vv, 2 * u.dot(v))) / 2);
  }

  /// PointDevice's, from cones within and about the view.
  [[nodiscard]] View view_of_ball(const Eigen::Vector3d& center, double radius) const {
    const Point<double> p{center.x(), center.y(), center.z()};
    const double distance = center.norm(), sure = radius + 1e-9 * distance;
    const double ends = std::min(reach(p) - near_, far_ - reach(p));
    if (std::min(ends, outer_.inside(p)) < -sure) return View::outside;
    return std::min(ends, inner_.inside(p)) > sure ? View::inside : View::crossing;
  }

  /// Whether look() says in metres how far inside the point is.
  [[nodiscard]] bool exact() const { return !bends_; }

 private:
  /// Directions that are walked along to find where the image ends.
  static constexpr int kWalks = 180;

  void set_focal(const ParamValues& p, double width) {
    const bool pixels = p["f_x"] > 0, angle = p["field_of_view"] > 0,
               length = p["focal"] > 0 || p["pitch"] > 0;
    if (pixels + angle + length != 1)
      throw std::invalid_argument(
          "give one of f_x (pixels), field_of_view, or focal and pitch");
    if (length && !(p["focal"] > 0 && p["pitch"] > 0))
      throw std::invalid_argument("focal and pitch go together");
    if (angle && !fisheye_ && !(p["field_of_view"] < std::numbers::pi))
      throw std::invalid_argument(
          "a field_of_view of half a turn or more needs distortion: fisheye");
    if (p["f_y"] > 0 && !pixels) throw std::invalid_argument("f_y goes with f_x");
    const double half = p["field_of_view"] / 2;
    f_[0] = pixels   ? p["f_x"]
            : length ? p["focal"] / p["pitch"]
                     : width / 2 / (fisheye_ ? half : std::tan(half));
    f_[1] = p["f_y"] > 0 ? p["f_y"] : f_[0];
  }

  /// (a′, b′).
  template <class T>
  void bend(const Point<T>& p, T& a, T& b) const {
    if (fisheye_) {
      const T factor = fisheye_factor(p);
      a = p.x * factor;
      b = p.y * factor;
      return;
    }
    const T z = depth(p);
    a = p.x / z;
    b = p.y / z;
    if (!bends_) return;
    const T ab = 2.0 * a * b, aa = a * a, bb = b * b, s = aa + bb;
    const T g = radial(s);
    a = a * g + p_[0] * ab + p_[1] * (s + 2.0 * aa);
    b = b * g + p_[1] * ab + p_[0] * (s + 2.0 * bb);
  }

  /// g of s, without the fisheye's k4.
  template <class T>
  [[nodiscard]] T radial(const T& s) const {
    const T g = 1.0 + s * (k_[0] + s * (k_[1] + s * k_[2]));
    if (!rational_) return g;
    return g / (1.0 + s * (k_[3] + s * (k_[4] + s * k_[5])));
  }

  /// θ′/ρ, which goes on linearly in z/d beyond the view; near the axis θ/ρ = (1 − t/3
  /// + t²/5 − t³/7 + t⁴/9)/z, t = ρ²/z².
  template <class T>
  T fisheye_factor(const Point<T>& p) const {
    using std::atan2, std::sqrt;
    if constexpr (std::is_same_v<T, SecondOrder>) {
      const T distance = sqrt(squared_norm(p)), cosine = p.z / distance;
      if (plain(cosine) < last_cosine_)
        return (last_factor_ + factor_slope_ * (cosine - last_cosine_)) / distance;
    }
    const T square = p.x * p.x + p.y * p.y;
    T factor, theta2;
    if (plain(p.z) > 0 && plain(square) < 1e-4 * plain(p.z) * plain(p.z)) {
      const T t = square / (p.z * p.z);
      const T series = 1.0 - t * (1.0 / 3 - t * (1.0 / 5 - t * (1.0 / 7 - t / 9.0)));
      factor = series / p.z;
      theta2 = t * series * series;
    } else {
      const T rho = AxisCone::aside(p), theta = atan2(rho, p.z);
      factor = theta / rho;
      theta2 = theta * theta;
    }
    return factor *
           (1.0 +
            theta2 * (k_[0] + theta2 * (k_[1] + theta2 * (k_[2] + theta2 * k_[3]))));
  }

  void set_view(double half_angle) {
    cosine_[0] = 1 / std::hypot(left_, 1);
    cosine_[1] = 1 / std::hypot(right_, 1);
    cosine_[2] = 1 / std::hypot(up_, 1);
    cosine_[3] = 1 / std::hypot(down_, 1);
    const double corner = std::hypot(std::max(-left_, right_), std::max(-up_, down_));
    bounded_ = bends_ || half_angle < std::numbers::pi;
    if (!bends_) {
      limit_ = AxisCone(half_angle);
      least_cosine_ = 0.7 / std::hypot(corner, 1);
      return;
    }
    const double limit = std::min(half_angle, last_angle(corner));
    limit_ = AxisCone(limit);
    bound_image(limit);
  }

  /// Cones within and about what the image shows, by walking from the axis outwards to
  /// where a ray leaves it.
  void bound_image(double limit) {
    const bool axis_in = left_ < 0 && right_ > 0 && up_ < 0 && down_ > 0;
    double least = axis_in ? limit : 0, most = axis_in ? 0 : limit;
    for (int i = 0; axis_in && i < kWalks; ++i) {
      const double way = 2 * std::numbers::pi * i / kWalks;
      double in = 0, out = limit;
      if (on_image(limit, way)) in = limit;
      while (out - in > 1e-7) {
        const double middle = (in + out) / 2;
        (on_image(middle, way) ? in : out) = middle;
      }
      least = std::min(least, in);
      most = std::max(most, out);
    }
    // A corner between two walks, 2 degrees apart, lies farther out, by less than a
    // tenth in images of up to 5 : 1; the middle of an edge nearer, by 2e-4.
    inner_ = AxisCone(0.999 * least);
    most = std::min(limit, 1.1 * most);
    outer_ = AxisCone(most);
    least_cosine_ = 0.7 * std::cos(std::min(most, 1.5));
    if (!fisheye_) return;
    const Dual<double, 1> last(most, 0), factor = radius_at(last) / sin(last);
    last_cosine_ = std::cos(most);
    last_factor_ = factor.value;
    factor_slope_ = -factor.slope[0] / std::sin(most);  // ∂/∂cos θ
  }

  [[nodiscard]] bool on_image(double angle, double way) const {
    double a, b;
    bend(Point<double>{std::sin(angle) * std::cos(way), std::sin(angle) * std::sin(way),
                       std::cos(angle)},
         a, b);
    return a >= left_ && a <= right_ && b >= up_ && b <= down_;
  }

  /// Up to where the image's radius grows with the angle, or is beyond its corners:
  /// rays from farther out would come back into the image. Nothing is seen of them.
  [[nodiscard]] double last_angle(double corner) const {
    const double most = fisheye_ ? std::numbers::pi - 1e-3 : 1.56;
    constexpr double kStep = 1e-3;
    double angle = 0;
    for (double radius = 0; angle + kStep < most && radius < 1.1 * corner;) {
      const double next = radius_at(fisheye_ ? angle + kStep : std::tan(angle + kStep));
      if (!(next > radius)) break;
      radius = next;
      angle += kStep;
    }
    return angle;
  }

  /// The distance from the image's centre, normalised, without p1 and p2: of the angle
  /// of a fisheye, else of its tangent.
  template <class T>
  [[nodiscard]] T radius_at(const T& r) const {
    const T s = r * r;
    if (!fisheye_) return r * radial(s);
    return r * (1.0 + s * (k_[0] + s * (k_[1] + s * (k_[2] + s * k_[3]))));
  }

  bool fisheye_, rational_;
  bool bends_ = false;    // it isn't a plain pinhole
  bool bounded_ = false;  // a cone bounds the view besides the image
  double near_, far_;     // m
  double k_[6], p_[2];
  double f_[2] = {};             // px
  double centre_[2] = {};        // px
  double left_ = 0, right_ = 0;  // edges of the image, normalised
  double up_ = 0, down_ = 0;
  double cosine_[4] = {};         // of the angles to them
  AxisCone limit_{0};             // what bounds the view besides the image
  AxisCone inner_{0}, outer_{0};  // within and about what is seen
  double least_cosine_ = 0;       // of the angle beyond which depth is smoothed
  // Of the angle beyond which a fisheye's θ′/sin θ is, that and its slope there.
  double last_cosine_ = -1, last_factor_ = 0, factor_slope_ = 0;
};

}  // namespace delos
