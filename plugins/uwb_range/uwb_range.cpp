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
#include <delos/device/range_device.h>
#include <delos/plugin.h>

namespace {

using delos::number;

class UwbRange final : public delos::RangeDevice {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      number("sigma", "m", "Standard deviation of a range to a tag nearby.")
          .initially(0.1)
          .between(1e-6, 10)
          .by_factors(),
      number("growth", "1",
             "Standard deviation per metre of range; R = sigma² + (growth z)².")
          .initially(0)
          .at_least(0),
      number("reach", "m", "Farthest tag that is ranged.").initially(50).at_least(0),
  };

  explicit UwbRange(const delos::ParamValues& p)
      : RangeDevice(p["sigma"] * p["sigma"], p["growth"] * p["growth"], p["reach"]) {}
};

}  // namespace

DELOS_DEVICE_PLUGIN(UwbRange, "uwb_range", "1.0.0",
                    "Range from an ultra-wideband anchor to a tag in its sight.");
