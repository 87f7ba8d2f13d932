#include "problem/reduce.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "problem/worst_case.h"

namespace delos {
namespace {

using Numbers = std::span<const double>;

double p_norm(double p, Numbers c, Numbers w, double* slopes) {
  const double most = *std::max_element(c.begin(), c.end());
  double sum = 0;
  for (std::size_t i = 0; i < c.size(); ++i) sum += w[i] * std::pow(c[i] / most, p);
  const double norm = most * std::pow(sum, 1 / p);
  for (std::size_t i = 0; slopes && i < c.size(); ++i)
    slopes[i] = w[i] * std::pow(c[i] / norm, p - 1);
  return norm;
}

double soft_max(double s, Numbers c, Numbers w, double* slopes) {
  double mean = 0, most = 0;
  for (std::size_t i = 0; i < c.size(); ++i) mean += w[i] * c[i];
  for (std::size_t i = 0; i < c.size(); ++i)
    if (w[i] > 0) most = std::max(most, c[i]);
  double sum = 0, first = 0;  // Σ w e,  Σ w e c,  e = exp(s (c − most)/M)
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double e = w[i] * std::exp(s * (c[i] - most) / mean);
    sum += e;
    first += e * c[i];
  }
  const double log_sum = s * most / mean + std::log(sum);
  for (std::size_t i = 0; slopes && i < c.size(); ++i) {
    const double e = w[i] * std::exp(s * (c[i] - most) / mean);
    slopes[i] = e / sum + w[i] * (log_sum / s - first / (mean * sum));
  }
  return mean / s * log_sum;
}

std::vector<std::size_t> by_cost(Numbers c, Numbers w) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < c.size(); ++i)
    if (w[i] > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return c[a] < c[b]; });
  return order;
}

/// Neighbours are the mean of their weights apart, as in field statistics.
double percentile(double level, Numbers c, Numbers w, double* slopes) {
  const std::vector<std::size_t> order = by_cost(c, w);
  if (slopes) std::fill_n(slopes, c.size(), 0.0);
  double length = 0;
  for (std::size_t k = 0; k + 1 < order.size(); ++k)
    length += (w[order[k]] + w[order[k + 1]]) / 2;
  double left = level * length;
  for (std::size_t k = 0; k + 1 < order.size(); ++k) {
    const std::size_t i = order[k], j = order[k + 1];
    const double step = (w[i] + w[j]) / 2;
    if (left < step) {
      const double part = left / step;
      if (slopes) slopes[i] = 1 - part, slopes[j] = part;
      return std::lerp(c[i], c[j], part);
    }
    left -= step;
  }
  if (slopes) slopes[order.back()] = 1;
  return c[order.back()];
}

double cvar(double level, Numbers c, Numbers w, double* slopes) {
  const std::vector<std::size_t> order = by_cost(c, w);
  if (slopes) std::fill_n(slopes, c.size(), 0.0);
  const double tail = 1 - level;
  double left = tail, sum = 0;
  for (std::size_t k = order.size(); k-- > 0 && left > 0;) {
    const double part = std::min(left, w[order[k]]);
    sum += part * c[order[k]];
    if (slopes) slopes[order[k]] = part / tail;
    left -= part;
  }
  return sum / tail;
}

/// Mean over the quantiles from one level to another.
double band(double from, double to, Numbers c, Numbers w, double* slopes) {
  std::vector<double> above(slopes ? c.size() : 0);
  const double sum =
      (1 - from) * cvar(from, c, w, slopes) -
      (to < 1 ? (1 - to) * cvar(to, c, w, slopes ? above.data() : nullptr) : 0);
  for (std::size_t i = 0; i < above.size(); ++i)
    slopes[i] = ((1 - from) * slopes[i] - (1 - to) * above[i]) / (to - from);
  return sum / (to - from);
}

double maximum(Numbers c, Numbers w, double* slopes) {
  const std::size_t worst = by_cost(c, w).back();
  if (slopes) std::fill_n(slopes, c.size(), 0.0), slopes[worst] = 1;
  return c[worst];
}

double soft_maximum(Numbers c, Numbers w, double* slopes) {
  std::vector<std::size_t> counted;
  std::vector<double> costs;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (w[i] > 0) counted.push_back(i), costs.push_back(c[i]);
  }
  std::vector<double> own(slopes ? costs.size() : 0);
  const double greatest =
      soft_greatest(costs, kSharpest, slopes ? own.data() : nullptr);
  if (slopes) std::fill_n(slopes, c.size(), 0.0);
  for (std::size_t k = 0; k < own.size(); ++k) slopes[counted[k]] = own[k];
  return greatest;
}

/// @param width of the step; 0: hard
double fraction(double limit, double width, Numbers c, Numbers w, double* slopes) {
  double sum = 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const double missed = width > 0 ? 1 / (1 + std::exp(-(c[i] - limit) / width))
                                    : (c[i] > limit ? 1 : 0);
    sum += w[i] * missed;
    if (slopes) slopes[i] = width > 0 ? w[i] * missed * (1 - missed) / width : 0;
  }
  return sum;
}

}  // namespace

double reduce(const ObjectiveTerm& term, Numbers c, Numbers w,
              std::optional<double> blur, double* slopes) {
  const double b = blur.value_or(0);
  switch (term.reduction) {
    case Reduction::mean:
      if (slopes) std::copy(w.begin(), w.end(), slopes);
      return std::inner_product(c.begin(), c.end(), w.begin(), 0.0);
    case Reduction::p_norm:
      return p_norm(b > 0 ? std::min(term.power, 1 / b) : term.power, c, w, slopes);
    case Reduction::soft_max:
      return b > 0 ? cvar(1 - b, c, w, slopes) : soft_max(term.sharpness, c, w, slopes);
    case Reduction::maximum:
      return b > 0  ? cvar(1 - b, c, w, slopes)
             : blur ? soft_maximum(c, w, slopes)
                    : maximum(c, w, slopes);
    case Reduction::percentile:
      return b > 0 ? band(std::max(0.0, term.level - b / 2),
                          std::min(1.0, term.level + b / 2), c, w, slopes)
                   : percentile(term.level, c, w, slopes);
    case Reduction::cvar:
      return cvar(std::min(term.level, 1 - b), c, w, slopes);
    case Reduction::fraction: {
      const double size = term.limit == 0 ? 1 : std::abs(term.limit);
      return fraction(term.limit, blur ? size * std::max(0.05, b) : 0, c, w, slopes);
    }
  }
  return 0;
}

}  // namespace delos
