// A speaker that a microphone on the target hears: it measures the distance between
// them.
//
//   z = ‖p‖ + v,   v ~ N(0, R),   R = r z²,   ∂z/∂p = pᵀ/‖p‖
//
// p is the microphone in the speaker's frame. Source: Allen & Welch (2005), "A general
// method for comparing the expected performance of tracking and motion capture
// systems", VRST '05, §2.1.2 (measurement) and §3.2 (noise).
#include <delos/plugin.h>

#include <cmath>

namespace {

class AcousticRange final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      {.name = "r",
       .initial = 0.005,
       .lower = 0,
       .help = "Variance of the range relative to its square; 0 is a perfect range."},
      {.name = "reach",
       .unit = "m",
       .initial = 1e6,
       .lower = 0,
       .help = "Farthest microphone that is heard; the default hears all."},
  };

  explicit AcousticRange(const delos::ParamValues& p)
      : r_(p["r"]), reach_(p["reach"]) {}

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    const double range = target.p_ST.norm();
    // At the speaker itself the range has no direction, hence no derivative.
    if (range == 0 || range > reach_) return false;
    out.z.setConstant(1, range);
    out.H = target.p_ST.transpose() / range;
    out.R.setConstant(1, 1, r_ * range * range);
    return true;
  }

  bool observe_lanes(const delos::PointLanes& points,
                     delos::RowLanes& out) const override {
    out.rows = 1;
    for (int l = 0; l < delos::kLanes; ++l) {
      const double x = points.p[0][l], y = points.p[1][l], z = points.p[2][l];
      const double range = std::sqrt(x * x + y * y + z * z);
      out.seen[l] = (range > 0) & (range <= reach_) ? 1 : 0;
      out.H[0][0][l] = x / range;
      out.H[0][1][l] = y / range;
      out.H[0][2][l] = z / range;
      out.variance[0][l] = r_ * range * range;
    }
    return true;
  }

  bool observe_smoothly(const Eigen::Vector3d& p,
                        delos::SmoothRows& out) const override {
    const double range = p.norm();
    if (range == 0 || r_ == 0) return false;
    const Eigen::Vector3d u = p / range;
    out.rows = 1;
    out.margin = (reach_ - range) / range;
    out.margin_slope = -reach_ / (range * range) * u;
    out.H.row(0) = u.transpose();
    out.variance(0) = r_ * range * range;
    const Eigen::Matrix3d turn =
        (Eigen::Matrix3d::Identity() - u * u.transpose()) / range;
    for (int k = 0; k < 3; ++k) out.H_slope[k].row(0) = turn.row(k);
    out.variance_slope.row(0) = 2 * r_ * p.transpose();
    return true;
  }

  delos::View view_of_ball(const Eigen::Vector3d& center,
                           double radius) const override {
    const double near = center.norm() - radius, far = center.norm() + radius;
    if (near > reach_) return delos::View::outside;
    return near > 0 && far < reach_ ? delos::View::inside : delos::View::crossing;
  }

 private:
  double r_;      // dimensionless
  double reach_;  // m
};

}  // namespace

DELOS_DEVICE_PLUGIN(AcousticRange, "acoustic_range", "1.0.0",
                    "Range from a speaker to a microphone, noise growing with range.");
