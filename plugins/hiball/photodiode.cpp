#include "photodiode.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hiball {
namespace {

constexpr double kElementaryCharge = 1.602176634e-19;  // C, exact by definition
constexpr double kBoltzmann = 1.380649e-23;            // J/K, exact by definition

double square(double x) { return x * x; }

/// Spot noise at the output of the amplifier that gets the current I, V/√Hz.
double spot_noise(const Photodiode& d, double I) {
  const double ratio = d.feedback / d.interelectrode;
  const double shot = square(d.feedback) * 2 * kElementaryCharge * I;
  const double own = square(d.voltage_noise * (1 + ratio));
  const double other = square(d.voltage_noise * ratio);
  const double current = square(d.feedback * d.current_noise);
  const double heat = 4 * kBoltzmann * d.temperature;
  const double of_diode = square(d.feedback) * heat / d.interelectrode;
  return std::sqrt(shot + own + other + current + of_diode + heat * d.feedback);
}

}  // namespace

double window_gain(const Photodiode& diode, double light) {
  const double a = std::numbers::pi * diode.bandwidth;
  const double aT = 2 * a * light, faded = std::exp(-aT);
  const double gap = std::exp(-2 * a * diode.gap);
  const double D1 = (std::expm1(-aT) + aT) / (2 * a);
  const double D2 = (1 - (1 + aT) * faded) * gap / (4 * a);
  const double D3 = gap * (faded * faded + aT * faded - faded) / (4 * a);
  return std::sqrt(std::max(0.0, 2 / square(light) * (D1 - D2 - D3)));
}

double position_noise(const Photodiode& diode, Sum sum, double gain, double x,
                      double cosine, double distance) {
  const double I = diode.current * cosine / square(distance);
  const double I1 = I * (1 + x) / 2, I2 = I * (1 - x) / 2;
  const double S1 = diode.feedback * I1, S2 = diode.feedback * I2;
  const double N1 = gain * spot_noise(diode, I1), N2 = gain * spot_noise(diode, I2);
  const double both =
      sum == Sum::linear ? N1 * S2 + N2 * S1 : std::hypot(N1 * S2, N2 * S1);
  return 2 * both / square(S1 + S2);
}

}  // namespace hiball
