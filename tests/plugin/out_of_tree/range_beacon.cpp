// A beacon that measures only how far away the target is (UWB, ultrasound).
//
//   z = ‖p‖ + v,   v ~ N(0, σ²)
//
// One beacon pins one direction; three well spread pin a point.
#include <delos/device/point_device.h>
#include <delos/plugin.h>

namespace {

class RangeBeacon final : public delos::PointDevice<RangeBeacon, 1> {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      delos::number("sigma", "m", "Noise, 1σ.").initially(0.05).at_least(0),
      delos::number("reach", "m", "Farthest heard.").initially(30).at_least(0),
  };

  explicit RangeBeacon(const delos::ParamValues& p)
      : variance_(p["sigma"] * p["sigma"]), reach_(p["reach"]) {}

  template <class T>
  void read(const delos::Point<T>& p, delos::Reading<T, 1>& out) const {
    using std::sqrt;
    out.z[0] = sqrt(squared_norm(p));
    out.variance[0] = variance_;
    out.inside = reach_ - out.z[0];
  }

 private:
  double variance_;  // m²
  double reach_;     // m
};

}  // namespace

DELOS_DEVICE_PLUGIN(RangeBeacon, "range_beacon", "1.0.0",
                    "Range-only beacon, e.g. UWB or ultrasound.");
