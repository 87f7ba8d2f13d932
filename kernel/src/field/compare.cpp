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
  c.difference.scene = second.scene + " − " + first.scene;
  double sum = 0;
  std::size_t improved = 0;
  for (std::size_t i = 0; i < first.value.size(); ++i) {
    const double a = first.value[i], b = second.value[i];
    double& difference = c.difference.value[i];
    difference = std::numeric_limits<double>::infinity();
    const double gain = first.larger_is_better ? b - a : a - b;
    if (std::isfinite(b) && (!std::isfinite(a) || gain > kRounding * std::abs(a))) {
      ++improved;
    }
    if (!std::isfinite(a) || !std::isfinite(b)) continue;
    difference = b - a;
    c.min = c.common ? std::min(c.min, difference) : difference;
    c.max = c.common ? std::max(c.max, difference) : difference;
    sum += difference;
    ++c.common;
  }
  if (c.common > 0) c.mean = sum / static_cast<double>(c.common);
  if (!first.value.empty()) {
    c.improved_fraction =
        static_cast<double>(improved) / static_cast<double>(first.value.size());
  }
  return c;
}

}  // namespace delos
