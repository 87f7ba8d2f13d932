#include "field/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace delos {
namespace {

/// The p-quantile of sorted values, linear between order statistics:
///
///   h = p (n − 1),   q = x_⌊h⌋ + (h − ⌊h⌋) (x_⌊h⌋₊₁ − x_⌊h⌋)
///
/// Source: Hyndman & Fan (1996), The American Statistician 50(4), 361–365, definition
/// 7;
///         the default of numpy and R.
double quantile(const std::vector<double>& sorted, double p) {
  const double h = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(h);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], h - static_cast<double>(below));
}

}  // namespace

FieldStatistics summarize_range(const Field& field, std::size_t first,
                                std::size_t count) {
  FieldStatistics s;
  s.samples = count;
  std::vector<double> finite;
  finite.reserve(count);
  double sum = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    if (field.observable[i] != 0) ++s.observable;
    const double value = field.value[i];
    if (!std::isfinite(value)) continue;
    if (finite.empty() || value < s.min.value) s.min = {value, field.samples.points[i]};
    if (finite.empty() || value > s.max.value) s.max = {value, field.samples.points[i]};
    sum += value;
    finite.push_back(value);
  }
  s.finite = finite.size();
  if (finite.empty()) return s;

  std::sort(finite.begin(), finite.end());
  s.mean = sum / static_cast<double>(finite.size());
  s.median = quantile(finite, 0.5);
  s.p95 = quantile(finite, 0.95);
  return s;
}

FieldStatistics summarize(const Field& field) {
  return summarize_range(field, 0, field.value.size());
}

}  // namespace delos
