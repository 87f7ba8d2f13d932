// A sound device, made into a bad plugin by how it is built.
#include <delos/plugin.h>

namespace {

class Good final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      {.name = "scale", .initial = 1, .help = "Metres to units."}};
  explicit Good(const delos::ParamValues& p) : scale_(p["scale"]) {}

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    out.z = scale_ * target.p_ST;
    out.H = scale_ * Eigen::Matrix3d::Identity();
    out.R.setIdentity(3, 3);
    return true;
  }

 private:
  double scale_;
};

}  // namespace

DELOS_DEVICE_PLUGIN(Good, PLUGIN_ID, "1.0.0", "Reads a position.");
