#include "delos/field/statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "delos/model/infinity.h"

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

/// The finite values outside solids, ascending.
std::vector<Weighted> sorted_values(const Field& field) {
  std::vector<Weighted> finite;
  for (std::size_t i = 0; i < field.value.size(); ++i)
    if ((field.inside.empty() || !field.inside[i]) && std::isfinite(field.value[i]))
      finite.push_back({field.value[i], field.weight.empty() ? 1 : field.weight[i]});
  std::sort(finite.begin(), finite.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  return finite;
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

namespace {

/// Two-sided 95 % of a normal distribution.
constexpr double kNormal95 = 1.959964;

/// Ratios of integrals from points in pairs, each pair drawn from a box of its own:
///
///   m = Σ wᵢ yᵢ / Σ wᵢ,   Var m ≈ Σ_k (r₂ₖ − r₂ₖ₊₁)² / (Σ wᵢ)²,   rᵢ = wᵢ (yᵢ − m)
///
/// over the points that count. Source: Cochran (1977), Sampling Techniques, 3rd ed.,
/// sections 5A.12 (two units a stratum) and 6.10 (the combined ratio).
class PairedPoints {
 public:
  /// @param counts(i) whether a point is part of what the ratio is about
  template <class Counts>
  PairedPoints(const Field& points, const Counts& counts)
      : weight_(points.weight), counts_(points.value.size()) {
    double largest = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      counts_[i] = (points.inside.empty() || !points.inside[i]) && counts(i);
      if (!counts_[i]) continue;
      whole_ += weight_[i];
      largest = std::max(largest, weight_[i]);
    }
    // What no point fell into: with 95 %, not more than −ln(0.05) = 3 of the largest
    // weights.
    if (whole_ > 0) missed_ = std::min(1.0, 3 * largest / whole_);
  }

  template <class Y>
  [[nodiscard]] double mean(const Y& y) const {
    double sum = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i)
      if (counts_[i]) sum += weight_[i] * y(i);
    return sum / whole_;
  }
  /// Half-width of the 95 % interval of a mean m.
  template <class Y>
  [[nodiscard]] double error(double m, const Y& y) const {
    double variance = 0;
    const auto rest = [&](std::size_t i) {
      return counts_[i] ? weight_[i] * (y(i) - m) : 0.0;
    };
    for (std::size_t i = 0; i + 1 < counts_.size(); i += 2) {
      const double difference = rest(i) - rest(i + 1);
      variance += difference * difference;
    }
    return kNormal95 * std::sqrt(variance) / whole_;
  }
  /// The same of a part of the volume.
  template <class Y>
  [[nodiscard]] double part_error(double m, const Y& y) const {
    return std::max(error(m, y), missed_);
  }
  [[nodiscard]] double missed() const { return missed_; }
  [[nodiscard]] double whole() const { return whole_; }

 private:
  const std::vector<double>& weight_;
  std::vector<char> counts_;
  double whole_ = 0, missed_ = 1;
};

/// Half-width of the 95 % interval of a quantile q: where the interval of the part of
/// the volume below it ends. Source: Woodruff (1952), Journal of the American
/// Statistical Association 47(260), 635–646.
double quantile_error(const Field& points, const PairedPoints& finite,
                      const std::vector<Weighted>& sorted, double p, double q) {
  const double e = finite.part_error(
      p, [&](std::size_t i) { return points.value[i] <= q ? 1.0 : 0.0; });
  return std::max(q - quantile(sorted, std::max(0.0, p - e)),
                  quantile(sorted, std::min(1.0, p + e)) - q);
}

/// What the points of a volume say of it.
void add_volume(const Field& points, FieldStatistics& s) {
  const FieldStatistics of = summarize_range(points, 0, points.value.size());
  VolumeStatistics v;
  v.points = of.samples;
  const PairedPoints outside(points, [](std::size_t) { return true; });
  if (outside.whole() == 0) return;
  const auto observable = [&](std::size_t i) {
    return points.observable[i] ? 1.0 : 0.0;
  };
  v.observable = outside.mean(observable);
  v.observable_error = outside.part_error(v.observable, observable);
  const auto one_short = [&](std::size_t i) {
    return !points.lost.empty() && points.lost[i] == 1 ? 1.0 : 0.0;
  };
  v.one_short = outside.mean(one_short);
  v.one_short_error = outside.part_error(v.one_short, one_short);
  v.beyond = outside.missed();
  v.mean_error = v.median_error = v.p95_error = kInfinity;
  if (of.finite > 0) {
    const auto is_finite = [&](std::size_t i) {
      return std::isfinite(points.value[i]);
    };
    const PairedPoints finite(points, is_finite);
    const std::vector<Weighted> sorted = sorted_values(points);
    s.mean = of.mean;
    s.median = of.median;
    s.p95 = of.p95;
    v.mean_error = finite.error(s.mean, [&](std::size_t i) { return points.value[i]; });
    v.median_error = quantile_error(points, finite, sorted, 0.5, s.median);
    v.p95_error = quantile_error(points, finite, sorted, 0.95, s.p95);
    if (s.finite == 0 || of.min.value < s.min.value) s.min = of.min;
    if (s.finite == 0 || of.max.value > s.max.value) s.max = of.max;
    if (s.finite == 0) s.finite = of.finite;
  }
  s.volume = v;
}

}  // namespace

FieldStatistics summarize(const Field& field) {
  FieldStatistics s = summarize_range(field, 0, field.value.size());
  if (field.spread) add_volume(*field.spread, s);
  return s;
}

}  // namespace delos
