#include "field/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace delos {
namespace {

struct Weighted {
  double value, weight;
};

/// The p-quantile of sorted values, linear between order statistics; for n equal
/// weights
///
///   h = p (n − 1),   q = x_⌊h⌋ + (h − ⌊h⌋) (x_⌊h⌋₊₁ − x_⌊h⌋)
///
/// Source: Hyndman & Fan (1996), The American Statistician 50(4), 361–365, definition
/// 7; the default of numpy and R. With weights, neighbours are the mean of their
/// weights apart.
double quantile(const std::vector<Weighted>& sorted, double p) {
  double length = -(sorted.front().weight + sorted.back().weight) / 2;
  for (const Weighted& at : sorted) length += at.weight;
  double left = p * length;
  for (std::size_t k = 0; k + 1 < sorted.size(); ++k) {
    const double step = (sorted[k].weight + sorted[k + 1].weight) / 2;
    if (left < step)
      return std::lerp(sorted[k].value, sorted[k + 1].value, left / step);
    left -= step;
  }
  return sorted.back().value;
}

}  // namespace

FieldStatistics summarize_range(const Field& field, std::size_t first,
                                std::size_t count) {
  FieldStatistics s;
  s.larger_is_better = field.larger_is_better;
  std::vector<Weighted> finite;
  finite.reserve(count);
  double sum = 0, weight = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    if (!field.inside.empty() && field.inside[i]) {
      ++s.inside;
      continue;
    }
    ++s.samples;
    if (field.observable[i] != 0) ++s.observable;
    if (!field.lost.empty() && field.lost[i] == 1) ++s.one_short;
    const double w = field.weight.empty() ? 1 : field.weight[i];
    const double value = field.value[i];
    if (!std::isfinite(value)) continue;
    if (finite.empty() || value < s.min.value) s.min = {value, field.samples.points[i]};
    if (finite.empty() || value > s.max.value) s.max = {value, field.samples.points[i]};
    sum += w * value;
    weight += w;
    finite.push_back({value, w});
  }
  s.finite = finite.size();
  if (finite.empty()) return s;

  std::sort(finite.begin(), finite.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  s.mean = sum / weight;
  s.median = quantile(finite, 0.5);
  s.p95 = quantile(finite, field.larger_is_better ? 1 - 0.95 : 0.95);
  return s;
}

FieldStatistics summarize(const Field& field) {
  return summarize_range(field, 0, field.value.size());
}

}  // namespace delos
