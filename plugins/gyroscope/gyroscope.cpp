// A gyroscope on the target: its angular rate about the sensor's axes.
//
//   z = R_SW ω + b + v,   v ~ N(0, sigma² I)
//
// ω is the target's angular rate, R_SW turns the world into the sensor's frame, b is a
// bias that drifts: delos/device/inertial_device.h. Source: Groves (2013), Principles
// of GNSS, inertial, and multisensor integrated navigation systems, 2nd ed., §4.4 and
// §14.2.6.
#include <delos/device/inertial_device.h>
#include <delos/plugin.h>

namespace {

class Gyroscope final : public delos::InertialDevice {
 public:
  static constexpr delos::ParamSpec kParams[] = {sigma("rad/s"), bias("rad/s"),
                                                 bias_time()};

  explicit Gyroscope(const delos::ParamValues& p)
      : InertialDevice(Measures::angular_rate, "rad/s", p) {}
};

}  // namespace

DELOS_DEVICE_PLUGIN(Gyroscope, "gyroscope", "1.0.0",
                    "Three-axis gyroscope on the target, with a bias that drifts.");
