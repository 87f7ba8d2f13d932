// What @ID@ measures of a point at p in its own frame.
//
//   z = ‖p‖ + v,   v ~ N(0, sigma²)
//
// Replace formula, parameters and text by your device's, and name its source.
#include <delos/device/point_device.h>
#include <delos/plugin.h>

namespace {

class @CLASS@ final : public delos::PointDevice<@CLASS@, 1> {
 public:
  // Scenes give these by name; searches step through them within their bounds.
  static constexpr delos::ParamSpec kParams[] = {
      delos::number("sigma", "m", "Standard deviation of a reading.")
          .initially(0.05)
          .between(1e-6, 100)
          .by_factors(),
      delos::number("reach", "m", "Farthest point that is measured.")
          .initially(30)
          .at_least(0),
  };

  explicit @CLASS@(const delos::ParamValues& p)
      : variance_(p["sigma"] * p["sigma"]), reach_(p["reach"]) {}

  // Written once: T is a number that carries its slopes.
  template <class T>
  void read(const delos::Point<T>& p, delos::Reading<T, 1>& out) const {
    using std::sqrt;
    out.z[0] = sqrt(squared_norm(p));
    out.variance[0] = variance_;
    out.inside = reach_ - out.z[0];  // metres; seen where it is at least 0
  }

 private:
  double variance_;  // m²
  double reach_;     // m
};

}  // namespace

DELOS_DEVICE_PLUGIN(@CLASS@, "@ID@", "0.1.0", "One sentence about @ID@.");
