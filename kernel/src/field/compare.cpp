#include <algorithm>
#include <cmath>
#include <limits>

#include "delos/field/evaluate.h"

namespace delos {
namespace {

/// Relative difference below which two values are the same but for rounding.
constexpr double kRounding = 1e-9;

}  // namespace

Comparison compare_fields(const Field& first, const Field& second) {
  Comparison c;
  c.difference = second;
  c.difference.spread = nullptr;
  c.difference.scene = second.scene + " − " + first.scene;
  double sum = 0, common = 0, improved = 0, all = 0;
  for (std::size_t i = 0; i < first.value.size(); ++i) {
    const double a = first.value[i], b = second.value[i];
    const double weight = first.weight.empty() ? 1 : first.weight[i];
    all += weight;
    double& difference = c.difference.value[i];
    difference = std::numeric_limits<double>::infinity();
    const double gain = first.larger_is_better ? b - a : a - b;
    if (std::isfinite(b) && (!std::isfinite(a) || gain > kRounding * std::abs(a))) {
      improved += weight;
    }
    if (!std::isfinite(a) || !std::isfinite(b)) continue;
    difference = b - a;
    c.min = c.common ? std::min(c.min, difference) : difference;
    c.max = c.common ? std::max(c.max, difference) : difference;
    sum += weight * difference;
    common += weight;
    ++c.common;
  }
  if (c.common > 0) c.mean = sum / common;
  if (all > 0) c.improved_fraction = improved / all;
  return c;
}

}  // namespace delos
