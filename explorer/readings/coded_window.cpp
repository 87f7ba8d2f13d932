#include "readings/coded_window.h"

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace delos::readings {
namespace {

/// Of the open chops: f(from, to) of their ages, summed.
template <class Function>
double over_open(const CodedWindow& window, Function&& f) {
  double sum = 0;
  const std::size_t count = window.open.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!window.open[i]) continue;
    const double to = static_cast<double>(count - i) * window.chop;
    sum += f(to - window.chop, to);
  }
  return sum;
}

/// E[aⁿ] of the ages.
double moment(const CodedWindow& window, int n) {
  return over_open(window,
                   [n](double from, double to) {
                     return (std::pow(to, n + 1) - std::pow(from, n + 1)) / (n + 1);
                   }) /
         window.light();
}

}  // namespace

double CodedWindow::light() const {
  double chops = 0;
  for (const bool lit : open) chops += lit;
  return chops * chop;
}

std::optional<std::vector<bool>> code_of(const std::string& digits) {
  constexpr std::size_t kMost = 1000;
  if (digits.size() > kMost || digits.find('1') == std::string::npos ||
      digits.find_first_not_of("01") != std::string::npos)
    return std::nullopt;
  std::vector<bool> open;
  for (const char digit : digits) open.push_back(digit == '1');
  return open;
}

double lever_of(const CodedWindow& window, int j) {
  return std::pow(-1, j) * moment(window, j) / std::tgamma(j + 1);
}

double motion_of(const CodedWindow& window, int order) {
  const double factorial = std::tgamma(order + 1);
  const auto g = [&](double b) {
    const double open = over_open(window, [&](double from, double to) {
      if (to <= b) return 0.0;
      return std::pow(to - b, order) - std::pow(std::max(0.0, from - b), order);
    });
    return open / factorial / window.light();
  };
  // A polynomial of degree 2k ≤ 6 between chops: four points are exact.
  double sum = 0;
  for (std::size_t i = 0; i < window.open.size(); ++i) {
    const double from = static_cast<double>(i) * window.chop;
    sum += boost::math::quadrature::gauss<double, 7>::integrate(
        [&](double b) { return g(b) * g(b); }, from, from + window.chop);
  }
  return sum;
}

double spread_of(const CodedWindow& window) {
  const double mean = moment(window, 1);
  return std::sqrt(moment(window, 2) - mean * mean);
}

Smear smear_of(const CodedWindow& window) {
  const std::size_t chops = window.open.size(), count = 2 * chops;
  const auto spectrum = [&](double f) {
    std::complex<double> sum = 0;
    double open = 0;
    for (std::size_t n = 0; n < chops; ++n) {
      if (!window.open[n]) continue;
      sum += std::polar(1.0, -2 * std::numbers::pi * f * static_cast<double>(n));
      ++open;
    }
    return std::abs(sum) / open;
  };
  // Of a sum of cosines that cancels, this much is rounding.
  constexpr double kNothing = 1e-9;
  Smear smear{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < count; ++i) {
    const double value = spectrum(static_cast<double>(i) / static_cast<double>(count));
    smear.least = std::min(smear.least, value);
    smear.noise_gain += 1 / (value * value) / static_cast<double>(count);
  }
  if (smear.least > kNothing) return smear;
  return {0, std::numeric_limits<double>::infinity()};
}

}  // namespace delos::readings
