// A camera that also measures the depth of what it sees, as pairs of cameras,
// projectors with a camera, and time of flight do.
//
//   (u, v) in pixels by delos/device/camera_model.h,  depth z
//
//   R = diag(sigma², sigma², σ_z²),   σ_z² = depth_sigma² + (depth_growth z²)²
//
// Two cameras a baseline B apart that match to s pixels have depth_growth = s/(f B).
// Sources: README.md.
#include <delos/device/camera_model.h>
#include <delos/device/point_device.h>
#include <delos/plugin.h>

namespace {

using delos::CameraModel, delos::CameraTable, delos::number;

class DepthCamera final : public delos::PointDevice<DepthCamera, 3> {
 public:
  static constexpr auto kParams = CameraTable::with({
      number("depth_sigma", "m", "Standard deviation of a depth nearby.")
          .initially(0)
          .at_least(0),
      number("depth_growth", "1/m",
             "What is added to it (squares are summed), per square of the depth.")
          .initially(0)
          .at_least(0),
      number(
          "baseline", "m",
          "Between its two cameras, or camera and projector: with subpixel instead of "
          "depth_growth.")
          .initially(0)
          .at_least(0),
      number("subpixel", "px", "Standard deviation of a disparity.")
          .initially(0)
          .at_least(0),
  });

  explicit DepthCamera(const delos::ParamValues& p)
      : camera_(p),
        variance_(p["sigma"] * p["sigma"]),
        depth_(p["depth_sigma"] * p["depth_sigma"]) {
    const bool stereo = p["baseline"] > 0;
    if (camera_.fisheye())
      throw std::invalid_argument(
          "measures depth along its axis, which a fisheye doesn't");
    if (stereo != (p["subpixel"] > 0))
      throw std::invalid_argument("baseline and subpixel go together");
    if (stereo && p["depth_growth"] > 0)
      throw std::invalid_argument("give either depth_growth or baseline and subpixel");
    if (!stereo && p["depth_growth"] == 0 && depth_ == 0)
      throw std::invalid_argument(
          "how well is a depth measured? give depth_sigma, depth_growth, or baseline "
          "and "
          "subpixel");
    second_ = p["baseline"];
    const double growth = stereo ? p["subpixel"] / (camera_.f_across() * p["baseline"])
                                 : p["depth_growth"];
    growing_ = growth * growth;
  }

  template <class T>
  void read(const delos::Point<T>& p, delos::Reading<T, 3>& out) const {
    camera_.look(p, out.z[0], out.z[1], out.inside);
    const T z = camera_.depth(p), square = z * z;
    out.z[2] = p.z;
    out.variance[0] = out.variance[1] = variance_;
    out.variance[2] = depth_ + growing_ * square * square;
  }

  delos::View view_of_ball(const Eigen::Vector3d& center,
                           double radius) const override {
    return camera_.exact() ? PointDevice::view_of_ball(center, radius)
                           : camera_.view_of_ball(center, radius);
  }

  /// Both eyes must see a point: the other one is a baseline along x away.
  std::vector<Eigen::Vector3d> lenses() const override {
    std::vector<Eigen::Vector3d> eyes = {Eigen::Vector3d::Zero()};
    if (second_ > 0) eyes.emplace_back(second_, 0, 0);
    return eyes;
  }

  double footprint(const Eigen::Vector3d& p) const override {
    return camera_.footprint(p);
  }

 private:
  CameraModel camera_;
  double variance_;     // px²
  double depth_;        // m²
  double growing_ = 0;  // 1/m²
  double second_ = 0;   // baseline, m
};

}  // namespace

DELOS_DEVICE_PLUGIN(DepthCamera, "depth_camera", "1.0.0",
                    "Camera that also measures depth, with noise that grows with it.");
