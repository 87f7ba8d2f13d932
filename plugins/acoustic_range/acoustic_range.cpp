// A speaker that a microphone on the target hears: it measures the distance between
// them.
//
//   z = ‖p‖ + v,   v ~ N(0, R),   R = r z²,   ∂z/∂p = pᵀ/‖p‖
//
// p is the microphone in the speaker's frame. Source: Allen & Welch (2005), "A general
// method for comparing the expected performance of tracking and motion capture
// systems", VRST '05, §2.1.2 (measurement) and §3.2 (noise).
#include <delos/device/range_device.h>
#include <delos/plugin.h>

namespace {

using delos::number;

class AcousticRange final : public delos::RangeDevice {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      number("r", "1",
             "Variance of the range relative to its square; 0 is a perfect range.")
          .initially(0.005)
          .at_least(0),
      number("reach", "m", "Farthest microphone that is heard; the default hears all.")
          .initially(1e6)
          .at_least(0),
  };

  explicit AcousticRange(const delos::ParamValues& p)
      : RangeDevice(0, p["r"], p["reach"]) {}
};

}  // namespace

DELOS_DEVICE_PLUGIN(AcousticRange, "acoustic_range", "1.0.0",
                    "Range from a speaker to a microphone, noise growing with range.");
