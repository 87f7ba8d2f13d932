// What sensors of the target's own motion have in common.
#pragma once

#include "delos/device/device.h"
#include "delos/device/parameters.h"

namespace delos {

/// Measures three numbers of the target's motion along its own axes, each off by a bias
/// that drifts, which the filter estimates with the motion:
///
///   z = m_S + b + v,   v ~ N(0, sigma² I)
///   db/dt = −b/T + w,   w white with density q = 2 bias²/T,   so that b ~ N(0, bias²)
///
/// A plugin derives from it and says which three.
class InertialDevice : public Device {
 public:
  /// The columns of Span::motion that it measures.
  enum class Measures { angular_rate = 9, acceleration = 12 };

  /// What a plugin's table of parameters has for it.
  /// @param unit of a reading
  static constexpr ParamSpec sigma(const char* unit) {
    return number("sigma", unit, "Standard deviation of a reading along each axis.")
        .at_least(0);
  }
  static constexpr ParamSpec bias(const char* unit) {
    return number("bias", unit,
                  "Standard deviation of the bias along each axis; 0: there is none.")
        .initially(0)
        .at_least(0);
  }
  static constexpr ParamSpec bias_time() {
    return number("bias_time", "s", "Time constant in which the bias drifts.")
        .initially(100)
        .at_least(1e-6);
  }

  InertialDevice(Measures what, const char* unit, const ParamValues& p)
      : columns_(static_cast<int>(what)),
        unit_(unit),
        variance_(p["sigma"] * p["sigma"]),
        time_constant_(p["bias_time"]),
        density_(2 * p["bias"] * p["bias"] / p["bias_time"]) {}

  [[nodiscard]] Span span() const override { return Span::motion; }

  [[nodiscard]] std::vector<OwnState> states() const override {
    if (density_ == 0) return {};
    return {{"bias_x", unit_, time_constant_, density_},
            {"bias_y", unit_, time_constant_, density_},
            {"bias_z", unit_, time_constant_, density_}};
  }

  [[nodiscard]] bool observe(const Target& target, Observation& out) const override {
    const bool biased = density_ > 0;
    out.z = columns_ == static_cast<int>(Measures::acceleration)
                ? target.acceleration.head<3>()
                : target.velocity.tail<3>();
    if (biased) out.z += target.own.head<3>();
    out.H.setZero(3, biased ? 21 : 18);
    out.H.middleCols<3>(columns_).setIdentity();
    if (biased) out.H.rightCols<3>().setIdentity();
    out.R.setIdentity(3, 3);
    out.R *= variance_;
    return true;
  }

 private:
  int columns_;
  const char* unit_;
  double variance_;       // of a reading, unit²
  double time_constant_;  // s
  double density_;        // unit²/s; 0: no bias
};

}  // namespace delos
