// An inertial measurement unit on the target: three rate gyroscopes and three
// accelerometers, each off by a bias that walks, as data sheets and calibrations state
// it.
//
//   z = [R_SW ω + b_ω; R_SW a + b_a] + v,   v ~ N(0, diag(N_ω² f I, N_a² f I))
//   db/dt = w,   w white with density K²
//
// N are noise densities, K those of the walks (bias instability), f the readings a
// second. Gravity is taken to be known and subtracted. Source: IEEE Std 952-1997,
// Annex C; J. Rehder et al. (2016), Extending kalibr, ICRA, 4304–4311, whose
// parameters these are.
#include <delos/plugin.h>

#include <string>
#include <vector>

namespace {

using delos::number;

class Imu final : public delos::Device {
 public:
  static constexpr delos::ParamSpec kParams[] = {
      number("rate_noise", "1", "Noise density of the gyroscopes, rad/s/√Hz.")
          .at_least(0),
      number("acceleration_noise", "1",
             "Noise density of the accelerometers, "
             "m/s²/√Hz.")
          .at_least(0),
      number("rate_walk", "1",
             "Random walk of the gyroscopes' biases, rad/s²/√Hz; 0: "
             "there is no bias.")
          .initially(0)
          .at_least(0),
      number("acceleration_walk", "1",
             "Random walk of the accelerometers' biases, "
             "m/s³/√Hz; 0: there is no bias.")
          .initially(0)
          .at_least(0),
      number("readings", "Hz",
             "Readings a second that the densities are of: the "
             "device's rate.")
          .at_least(1e-3),
  };

  explicit Imu(const delos::ParamValues& p)
      : sides_{side("rate", p, "rad/s"), side("acceleration", p, "m/s^2")} {}

  delos::Span span() const override { return delos::Span::motion; }

  std::vector<delos::OwnState> states() const override {
    std::vector<delos::OwnState> all;
    for (const Side& side : sides_) {
      if (side.density == 0) continue;
      for (const char* axis : {"x", "y", "z"})
        all.push_back({.name = std::string(side.name) + "_bias_" + axis,
                       .unit = side.unit,
                       .density = side.density});
    }
    return all;
  }

  bool observe(const delos::Target& target, delos::Observation& out) const override {
    out.z.resize(6);
    out.z << target.velocity.tail<3>(), target.acceleration.head<3>();
    out.H.setZero(6, 18 + target.own.size());
    out.R.setZero(6, 6);
    Eigen::Index own = 0;
    for (int s = 0; s < 2; ++s) {
      // ω are columns 9 to 11 of Span::motion, a 12 to 14.
      out.H.block<3, 3>(3 * s, 9 + 3 * s).setIdentity();
      out.R.diagonal().segment<3>(3 * s).setConstant(sides_[s].variance);
      if (sides_[s].density == 0) continue;
      out.z.segment<3>(3 * s) += target.own.segment<3>(own);
      out.H.block<3, 3>(3 * s, 18 + own).setIdentity();
      own += 3;
    }
    return true;
  }

 private:
  struct Side {
    const char *name, *unit;
    double variance;  // of a reading, unit²
    double density;   // of the bias's walk, unit²/s; 0: no bias
  };

  static Side side(const char* name, const delos::ParamValues& p, const char* unit) {
    const double noise = p[std::string(name) + "_noise"],
                 walk = p[std::string(name) + "_walk"];
    return {name, unit, noise * noise * p["readings"], walk * walk};
  }

  Side sides_[2];
};

}  // namespace

DELOS_DEVICE_PLUGIN(Imu, "imu", "1.0.0",
                    "Gyroscopes and accelerometers by noise densities and bias walks.");
