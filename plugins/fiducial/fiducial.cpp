// A camera that reads a square tag on the target: its four corners on the image, all of
// them or none, so that one tag says the whole pose.
//
//   corner c of the tag, (±s/2, ±s/2, 0) in the tag's frame, stands in the camera at
//   p_c = p_ST + R_ST a_c,   a_c = at + R(rpy) c
//   (u, v)_c by delos/device/camera_model.h,   R = sigma² I₈
//   ∂(u, v)_c/∂[δp, δθ] = [h, a × h],   h = ∂(u, v)_c/∂p_c,  a = R_ST a_c
//
// Read where every corner is in view, and the camera is at most tag_half_angle off the
// tag's normal, its z axis. The tag is least_size pixels wide or more, as it would be
// facing the camera.
#include <delos/device/camera_model.h>
#include <delos/model/pose.h>
#include <delos/plugin.h>

#include <Eigen/Geometry>

namespace {

using delos::CameraModel, delos::CameraTable, delos::number, delos::vector;

class Fiducial final : public delos::Device {
 public:
  static constexpr auto kParams = CameraTable::with({
      number("size", "m", "Edge of the tag.").between(1e-4, 100),
      vector("tag_at", "m", 3, "Its middle, on the target.").initially("[0, 0, 0]"),
      vector(
          "tag_rpy", "rad", 3,
          "How it is turned there: roll, pitch, yaw. Its z axis is the way it faces.")
          .initially("[0, 0, 0]"),
      number("tag_half_angle", "rad",
             "Greatest angle between its normal and the way to the camera.")
          .initially(1.2)
          .between(0.01, 1.57),
      number("least_size", "px", "Least edge on the image that is read.")
          .initially(0)
          .at_least(0),
  });

  explicit Fiducial(const delos::ParamValues& p)
      : camera_(p),
        variance_(p["sigma"] * p["sigma"]),
        at_(p.matrix("tag_at")),
        cosine_(std::cos(p["tag_half_angle"])) {
    if (p["least_size"] > 0)
      camera_.limit_far(std::sqrt(camera_.f_across() * camera_.f_down()) * p["size"] /
                        p["least_size"]);
    const Eigen::Matrix3d R = delos::rotation_from_rpy(p.matrix("tag_rpy"));
    normal_ = R.col(2);
    for (int c = 0; c < kCorners; ++c)
      corners_[c] = at_ + p["size"] / 2 * R *
                              Eigen::Vector3d(c % 3 == 0 ? -1 : 1, c < 2 ? -1 : 1, 0);
  }

  delos::Span span() const override { return delos::Span::pose; }
  bool needs_sight() const override { return true; }
  double footprint(const Eigen::Vector3d& p) const override {
    return camera_.footprint(p);
  }

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    const Eigen::Vector3d middle = target.p_ST + target.R_ST * at_;
    if (!(-middle.dot(target.R_ST * normal_) >= cosine_ * middle.norm())) return false;
    out.z.resize(2 * kCorners);
    out.H.resize(2 * kCorners, 6);
    for (int c = 0; c < kCorners; ++c) {
      const Eigen::Vector3d arm = target.R_ST * corners_[c], p = target.p_ST + arm;
      delos::FirstOrder image[2], inside;
      camera_.look(delos::independent(p.x(), p.y(), p.z()), image[0], image[1], inside);
      if (!(inside.value >= 0)) return false;
      for (int i = 0; i < 2; ++i) {
        const Eigen::Map<const Eigen::Vector3d> h(image[i].slope);
        out.z(2 * c + i) = image[i].value;
        out.H.row(2 * c + i) << h.transpose(), arm.cross(h).transpose();
      }
    }
    out.R.setIdentity(2 * kCorners, 2 * kCorners);
    out.R *= variance_;
    return true;
  }

 private:
  static constexpr int kCorners = 4;
  CameraModel camera_;
  double variance_;     // px²
  Eigen::Vector3d at_;  // of its middle, in the target's frame, m
  double cosine_;       // of the greatest angle off its normal
  Eigen::Vector3d normal_;
  Eigen::Vector3d corners_[kCorners];  // in the target's frame, m
};

}  // namespace

DELOS_DEVICE_PLUGIN(Fiducial, "fiducial", "1.0.0",
                    "Camera that reads a square tag on the target whole: its pose.");
