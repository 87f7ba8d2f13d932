// A beacon that measures only how far away the target is (UWB, ultrasound).
//
//   z = ‖p‖ + v,   v ~ N(0, σ²),   ∂z/∂p = pᵀ / ‖p‖
//
// One beacon pins one direction; three well spread pin a point.
#include <delos/plugin.h>

namespace {

class RangeBeacon final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      {.name = "sigma", .unit = "m", .initial = 0.05, .lower = 0, .help = "Noise, 1σ."},
      {.name = "reach",
       .unit = "m",
       .initial = 30,
       .lower = 0,
       .help = "Farthest heard."},
  };

  explicit RangeBeacon(const delos::ParamValues& p)
      : variance_(p["sigma"] * p["sigma"]), reach_(p["reach"]) {}

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    const double range = target.p_ST.norm();
    if (range == 0 || range > reach_) return false;
    out.z.setConstant(1, range);
    out.H = target.p_ST.transpose() / range;
    out.R.setConstant(1, 1, variance_);
    return true;
  }

 private:
  double variance_;  // m²
  double reach_;     // m
};

}  // namespace

DELOS_DEVICE_PLUGIN(RangeBeacon, "range_beacon", "1.0.0",
                    "Range-only beacon, e.g. UWB or ultrasound.");
