// A beacon whose range is off by a bias that drifts, and that the filter estimates.
//
//   z = ‖p‖ + b + v,   v ~ N(0, σ²),   db/dt = −b/T + w,   b ~ N(0, bias²)
#include <delos/plugin.h>

namespace {

class BiasedBeacon final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      delos::number("sigma", "m", "Noise, 1σ.").initially(0.05).at_least(0),
      delos::number("bias", "m", "Bias, 1σ.").initially(0.1).at_least(0),
      delos::number("time", "s", "How fast it drifts.").initially(60).at_least(1e-3),
  };

  explicit BiasedBeacon(const delos::ParamValues& p)
      : variance_(p["sigma"] * p["sigma"]),
        bias_{.name = "bias",
              .unit = "m",
              .time_constant = p["time"],
              .density = 2 * p["bias"] * p["bias"] / p["time"]} {}

  std::vector<delos::OwnState> states() const override { return {bias_}; }

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    const double range = target.p_ST.norm();
    if (range == 0) return false;
    out.z.setConstant(1, range + target.own(0));
    out.H.resize(1, 4);
    out.H << target.p_ST.transpose() / range, 1;
    out.R.setConstant(1, 1, variance_);
    return true;
  }

 private:
  double variance_;  // m²
  delos::OwnState bias_;
};

}  // namespace

DELOS_DEVICE_PLUGIN(BiasedBeacon, "biased_beacon", "1.0.0",
                    "Range beacon with a bias that drifts.");
