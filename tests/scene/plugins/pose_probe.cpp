// A device that measures the target's whole pose.
#include <delos/plugin.h>

namespace {

class PoseProbe final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      {.name = "r", .initial = 1, .lower = 0, .help = "Variance of a reading."},
  };

  explicit PoseProbe(const delos::ParamValues& p) : r_(p["r"]) {}

  delos::Span span() const override { return delos::Span::pose; }
  bool observe(const delos::Target&, delos::Observation& out) const override {
    out.z.setZero(6);
    out.H.setIdentity(6, 6);
    out.R = r_ * Eigen::Matrix<double, 6, 6>::Identity();
    return true;
  }

 private:
  double r_;
};

}  // namespace

DELOS_DEVICE_PLUGIN(PoseProbe, "pose_probe", "1.0.0", "Measures the whole pose.");
