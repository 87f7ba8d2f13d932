// An accelerometer on the target: its linear acceleration along the sensor's axes.
//
//   z = R_SW a + b + v,   v ~ N(0, sigma² I)
//
// a is the sensor's own acceleration, the target's and what an arm adds, R_SW turns the
// world into the sensor's frame, b is a bias that drifts:
// delos/device/inertial_device.h. Gravity is taken to be known and subtracted. Source:
// Groves (2013), Principles of GNSS, inertial, and multisensor integrated navigation
// systems, 2nd ed., §4.4 and §14.2.6.
#include <delos/device/inertial_device.h>
#include <delos/plugin.h>

namespace {

class Accelerometer final : public delos::InertialDevice {
 public:
  static constexpr delos::ParamSpec kParams[] = {sigma("m/s^2"), bias("m/s^2"),
                                                 bias_time()};

  explicit Accelerometer(const delos::ParamValues& p)
      : InertialDevice(Measures::acceleration, "m/s^2", p) {}
};

}  // namespace

DELOS_DEVICE_PLUGIN(Accelerometer, "accelerometer", "1.0.0",
                    "Three-axis accelerometer on the target, with a bias that drifts.");
