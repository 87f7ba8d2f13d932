#include "output/ticks.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "delos/text/format.h"
#include "delos/text/number_text.h"

namespace delos {
namespace {

/// The smallest of 1, 2, 5 × 10ᵏ that is at least `raw`.
struct NiceStep {
  double size;
  int decimals;  ///< digits after the point that its multiples need
};

NiceStep nice_step(double raw) {
  const int power = static_cast<int>(std::floor(std::log10(raw)));
  const double unit = std::pow(10.0, power);
  // The slack keeps 0.2 from becoming 0.5 by a rounding error.
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * unit >= raw * (1 - 1e-9)) return {factor * unit, -power};
  return {10 * unit, -power - 1};
}

/// The multiples of powers of ten within [low, high], in every `stride`-th decade.
std::vector<double> decades(std::initializer_list<double> multiples, int stride,
                            double low, double high) {
  std::vector<double> values;
  const int from = static_cast<int>(std::floor(std::log10(low)));
  const int to = static_cast<int>(std::floor(std::log10(high)));
  for (int power = from; power <= to; ++power) {
    if (power % stride != 0) continue;
    for (const double multiple : multiples) {
      // Positive powers up to 10²² are exact, negative ones aren't.
      const double value = power < 0 ? multiple / std::pow(10.0, -power)
                                     : multiple * std::pow(10.0, power);
      if (value >= low && value <= high) values.push_back(value);
    }
  }
  return values;
}

}  // namespace

std::vector<Tick> linear_ticks(double low, double high, int wanted) {
  const double span = high - low;
  if (!(span > 0)) return {{low, rounded(low, 6)}};
  const NiceStep step = nice_step(span / std::max(1, wanted));
  std::vector<Tick> ticks;
  const double slack = 1e-9 * step.size;
  const double first = std::ceil((low - slack) / step.size);
  const double last = std::floor((high + slack) / step.size);
  for (double i = first; i <= last; ++i) {
    const double value = std::clamp(i * step.size, low, high);
    ticks.push_back({value, with_decimals(i * step.size, step.decimals)});
  }
  return ticks;
}

std::vector<Tick> log_ticks(double low, double high, int wanted,
                            const std::string& unit) {
  // In the unit that is shown: round numbers of radians are no round numbers of
  // degrees.
  const double factor = display_unit(high, unit).factor;
  const auto most = static_cast<std::size_t>(std::max(4, wanted));
  std::vector<double> values = decades({1, 2, 5}, 1, low * factor, high * factor);
  if (values.size() > most) values = decades({1, 3}, 1, low * factor, high * factor);
  for (int stride = 1; values.size() > most; ++stride)
    values = decades({1}, stride, low * factor, high * factor);

  int digits = 3;
  if (values.size() < 2) {
    values.clear();
    for (const Tick& tick : linear_ticks(low * factor, high * factor, wanted))
      values.push_back(tick.value);
    digits = 6;
  }
  std::vector<Tick> ticks;
  for (const double value : values)
    ticks.push_back({value / factor, format_quantity(value / factor, unit, digits)});
  return ticks;
}

}  // namespace delos
