// An ultra-wideband radio on a wall and a tag on the target: two-way ranging measures
// the distance between them.
//
//   z = ‖p‖ + v,   v ~ N(0, R),   R = sigma² + (growth z)²,   ∂z/∂p = pᵀ/‖p‖
//
// p is the tag in the anchor's frame. A tag that is hidden isn't ranged: a pulse that
// goes around or through something comes late, and such ranges are discarded. Source of
// the noise's form: Cramér–Rao bounds of a time of arrival, whose clock adds a part
// that doesn't depend on range; Dardari et al. (2009), Ranging with ultrawide bandwidth
// signals in multipath environments, Proc. IEEE 97(2), §III.
#include <delos/plugin.h>

#include <cmath>

namespace {

class UwbRange final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      {.name = "sigma",
       .unit = "m",
       .initial = 0.1,
       .lower = 1e-6,
       .upper = 10,
       .scale = delos::ParamScale::log,
       .help = "Standard deviation of a range to a tag nearby."},
      {.name = "growth",
       .initial = 0,
       .lower = 0,
       .help = "What far tags add to it, per metre of range."},
      {.name = "reach",
       .unit = "m",
       .initial = 50,
       .lower = 0,
       .help = "Farthest tag that is ranged."},
  };

  explicit UwbRange(const delos::ParamValues& p)
      : constant_(p["sigma"] * p["sigma"]),
        growing_(p["growth"] * p["growth"]),
        reach_(p["reach"]) {}

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    const double range = target.p_ST.norm();
    // At the anchor itself the range has no direction, hence no derivative.
    if (range == 0 || range > reach_) return false;
    out.z.setConstant(1, range);
    out.H = target.p_ST.transpose() / range;
    out.R.setConstant(1, 1, constant_ + growing_ * range * range);
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
      out.variance[0][l] = constant_ + growing_ * range * range;
    }
    return true;
  }

  bool observe_smoothly(const Eigen::Vector3d& p,
                        delos::SmoothRows& out) const override {
    const double range = p.norm();
    if (range == 0) return false;
    const Eigen::Vector3d u = p / range;
    out.rows = 1;
    out.margin = (reach_ - range) / range;
    out.margin_slope = -reach_ / (range * range) * u;
    out.H.row(0) = u.transpose();
    out.variance(0) = constant_ + growing_ * range * range;
    const Eigen::Matrix3d turn =
        (Eigen::Matrix3d::Identity() - u * u.transpose()) / range;
    for (int k = 0; k < 3; ++k) out.H_slope[k].row(0) = turn.row(k);
    out.variance_slope.row(0) = 2 * growing_ * p.transpose();
    return true;
  }

  delos::View view_of_ball(const Eigen::Vector3d& center,
                           double radius) const override {
    const double near = center.norm() - radius, far = center.norm() + radius;
    if (near > reach_) return delos::View::outside;
    return near > 0 && far < reach_ ? delos::View::inside : delos::View::crossing;
  }

 private:
  double constant_;  // m²
  double growing_;   // dimensionless
  double reach_;     // m
};

}  // namespace

DELOS_DEVICE_PLUGIN(UwbRange, "uwb_range", "1.0.0",
                    "Range from an ultra-wideband anchor to a tag in its sight.");
