// A calibrated camera that sees a point: where it lies on the image, in pixels.
//
//   (u, v) by delos/device/camera_model.h, each with independent noise
//
//   noise: pixels   R = sigma² I
//   noise: image    R(u) = (width n)², R(v) = (height n)²,
//                   n = (floor + growth d)/cos θ
//
// d is the distance, θ the angle to the optical axis. Source of the latter: Allen
// (2007), "Hardware design optimization for human motion tracking systems",
// dissertation, Eq. 49–51. A marker of a diameter D covers f D/depth pixels; where that
// is less than least_size it isn't seen.
#include <delos/device/camera_model.h>
#include <delos/device/point_device.h>
#include <delos/plugin.h>

namespace {

using delos::CameraModel, delos::CameraTable, delos::choice, delos::number;

class Camera final : public delos::PointDevice<Camera, 2> {
 public:
  static constexpr auto kParams = CameraTable::with({
      choice("noise", "pixels|image",
             "Whether the noise is sigma everywhere, or a part of the image that grows "
             "with distance and off-axis angle.")
          .initially("pixels"),
      number("floor", "1",
             "Noise on the axis nearby, as a part of the image, for noise: image.")
          .initially(0.00195)
          .at_least(0),
      number("growth", "1/m", "What each metre of distance adds to it.")
          .initially(0.0046)
          .at_least(0),
      number("marker", "m", "Diameter of what is seen; 0: a point.")
          .initially(0)
          .at_least(0),
      number("least_size", "px", "Least diameter on the image that is seen.")
          .initially(0)
          .at_least(0),
  });

  explicit Camera(const delos::ParamValues& p) : camera_(p) {
    const bool image = p.choice("noise") == "image";
    if (image && camera_.fisheye())
      throw std::invalid_argument("noise: image is for lenses that aren't a fisheye");
    if (image) {
      floor_ = p["floor"];
      growth_ = p["growth"];
    } else {
      constant_ = p["sigma"] * p["sigma"];
    }
    if (!(p["least_size"] > 0)) return;
    if (!(p["marker"] > 0))
      throw std::invalid_argument(
          "a least_size needs the diameter of what is seen, marker");
    camera_.limit_far(std::sqrt(camera_.f_across() * camera_.f_down()) * p["marker"] /
                      p["least_size"]);
  }

  double footprint(const Eigen::Vector3d& p) const override {
    return camera_.footprint(p);
  }

  template <class T>
  void read(const delos::Point<T>& p, delos::Reading<T, 2>& out) const {
    camera_.look(p, out.z[0], out.z[1], out.inside);
    out.variance[0] = out.variance[1] = constant_;
    if (growing()) {
      using std::sqrt;
      const T d = sqrt(squared_norm(p));
      const T part = (floor_ + growth_ * d) * d / camera_.depth(p);
      out.variance[0] = camera_.width() * camera_.width() * part * part;
      out.variance[1] = camera_.height() * camera_.height() * part * part;
    }
  }

  delos::View view_of_ball(const Eigen::Vector3d& center,
                           double radius) const override {
    return camera_.exact() ? PointDevice::view_of_ball(center, radius)
                           : camera_.view_of_ball(center, radius);
  }

 private:
  [[nodiscard]] bool growing() const { return floor_ + growth_ > 0; }

  CameraModel camera_;
  double constant_ = 0;            // px²
  double floor_ = 0, growth_ = 0;  // parts of the image, and a metre
};

}  // namespace

DELOS_DEVICE_PLUGIN(
    Camera, "camera", "1.0.0",
    "Calibrated camera, with distortion, that sees points on its image.");
