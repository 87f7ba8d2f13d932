#include "problem/worst_case.h"

#include <algorithm>
#include <cmath>

namespace delos {

// With p = exp(s F/M)/Σ exp(s F/M), of the entropy H = −Σ p log p,
//
//   ∂/∂F_c = p_c + ∂M/∂F_c H/s,   ∂M/∂F_c = F_c/(n M)
double soft_greatest(std::span<const double> values, double sharpness, double* slopes) {
  const auto n = static_cast<double>(values.size());
  double square = 0;
  for (const double F : values) square += F * F / n;
  const double M = std::sqrt(square);
  if (M == 0) {
    if (slopes) std::fill_n(slopes, values.size(), 1 / n);
    return 0;
  }
  const double greatest = *std::max_element(values.begin(), values.end());
  const auto exponent = [&](double F) { return sharpness * (F - greatest) / M; };
  double sum = 0, mean = 0;  // Σ e, and the mean exponent by p
  for (const double F : values) {
    const double e = std::exp(exponent(F));
    sum += e;
    mean += e * exponent(F);
  }
  mean /= sum;
  const double entropy = std::log(sum) - mean;
  for (std::size_t c = 0; slopes && c < values.size(); ++c)
    slopes[c] =
        std::exp(exponent(values[c])) / sum + values[c] / (n * M) * entropy / sharpness;
  return greatest + M / sharpness * std::log(sum);
}

}  // namespace delos
