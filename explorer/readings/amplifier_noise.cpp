#include "readings/amplifier_noise.h"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "delos/scene/sample_time.h"

namespace delos::readings {
namespace {

constexpr double kElementaryCharge = 1.602176634e-19;  // C, exact by definition
constexpr double kBoltzmann = 1.380649e-23;            // J/K, exact by definition
constexpr double kPi = std::numbers::pi;

double square(double x) { return x * x; }

/// ∫ |W(f)|²/(1 + (f/f0)²) df/f, of a light window less a dark one:
///
///     |W|² = sinc²(f T) 4 sin²(π f (T + T0))
///
/// The integrand is smooth over a period of the faster sine, and falls as f⁻³.
double pink_gain(const Amplifier& a, double window) {
  const double period = 1 / (window + a.gap);
  const auto integrand = [&](double f) {
    const double x = kPi * f * window;
    const double sinc = std::abs(x) < 1e-6 ? 1 : std::sin(x) / x;
    return square(sinc) * 4 * square(std::sin(kPi * f / period)) /
           (1 + square(f / a.bandwidth)) / f;
  };
  // So many lobes of sinc² leave 2/(π n)² of about 1.
  constexpr double kLobes = 400;
  const auto periods = static_cast<long>(std::ceil(kLobes / window / period));
  double sum = 0;
  for (long i = 0; i < periods; ++i)
    sum += boost::math::quadrature::gauss<double, 15>::integrate(
        integrand, static_cast<double>(i) * period,
        static_cast<double>(i + 1) * period);
  return sum;
}

}  // namespace

double johnson_noise(double resistance, double temperature, double bandwidth) {
  return std::sqrt(4 * kBoltzmann * temperature * resistance * bandwidth);
}

double shot_noise(double current, double bandwidth) {
  return std::sqrt(2 * kElementaryCharge * current * bandwidth);
}

std::array<SourceNoise, kSources> noise_of(const Amplifier& a, double current,
                                           double window) {
  const double ratio = a.feedback / a.interelectrode;
  const double of_diode = 4 * kBoltzmann * a.temperature / a.interelectrode;
  const double white = square(photodiode_gain(window, a.bandwidth, a.gap));
  // G² is twice what the windows leave of white noise: its 1/f part counts alike.
  const bool corners = a.voltage_corner > 0 || a.current_corner > 0;
  const double pink = corners ? 2 * pink_gain(a, window) : 0;
  const auto source = [&](double density, double corner) {
    return SourceNoise{density, density * std::sqrt(white + corner * pink)};
  };
  return {source(a.feedback * shot_noise(current, 1), 0),
          source(a.voltage * (1 + ratio), a.voltage_corner),
          source(a.voltage * ratio, a.voltage_corner),
          source(a.feedback * a.current, a.current_corner),
          source(a.feedback * std::sqrt(of_diode), 0),
          source(johnson_noise(a.feedback, a.temperature, 1), 0)};
}

PositionNoise position_noise(const Amplifier& a, double current, double x,
                             double window, double readings) {
  PositionNoise out;
  out.current = {current * (1 + x) / 2, current * (1 - x) / 2};
  for (std::size_t end = 0; end < 2; ++end) {
    out.sources[end] = noise_of(a, out.current[end], window);
    double sum = 0;
    for (SourceNoise& source : out.sources[end]) {
      source.rms /= std::sqrt(readings);
      sum += square(source.rms);
    }
    out.rms[end] = std::sqrt(sum);
  }
  const double S1 = a.feedback * out.current[0], S2 = a.feedback * out.current[1];
  const double first = out.rms[0] * S2, second = out.rms[1] * S1;
  out.linear = 2 * (first + second) / square(S1 + S2);
  out.independent = 2 * std::hypot(first, second) / square(S1 + S2);
  return out;
}

}  // namespace delos::readings
