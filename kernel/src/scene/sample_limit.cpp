#include "scene/sample_limit.h"

#include <algorithm>
#include <cmath>

#include "delos/sampling/samples.h"
#include "delos/text/number_text.h"
#include "delos/text/numbers.h"
#include "delos/text/units.h"

namespace delos {
namespace {

/// A point (24), its value and flag, and what a writer holds of them.
constexpr double kBytesPerSample = 40;

std::string memory(std::int64_t samples) {
  const double bytes = kBytesPerSample * static_cast<double>(samples);
  return bytes < 1e12 ? rounded(bytes / 1e9, 2) + " GB"
                      : rounded(bytes / 1e12, 2) + " TB";
}

/// The least number of two significant digits that isn't below the value.
double rounded_up(double value) {
  const int exponent = static_cast<int>(std::floor(std::log10(value))) - 1;
  const double digits = std::ceil(value / std::pow(10.0, exponent) - 1e-9);
  return scaled_decimal(shortest(digits), exponent);
}

SampleSet with_step(const VolumeSampling& volume, double factor) {
  VolumeSampling coarser = volume;
  for (double& step : coarser.step) step = rounded_up(step * factor);
  return {{}, coarser};
}

/// The finest step, as a multiple of the given one, whose samples fit.
std::string fitting_step(const VolumeSampling& volume, std::int64_t most) {
  double too_fine = 1, fits = 2;
  while (sample_count(with_step(volume, fits)) > most) fits *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = (too_fine + fits) / 2;
    (sample_count(with_step(volume, middle)) > most ? too_fine : fits) = middle;
  }
  const auto step = std::get<VolumeSampling>(with_step(volume, fits).shape).step;
  if (step.x() == step.y() && step.y() == step.z()) return shortest(step.x());
  return '[' + shortest(step.x()) + ", " + shortest(step.y()) + ", " +
         shortest(step.z()) + ']';
}

std::string fitting_counts(const PlaneSampling& plane, std::int64_t most) {
  const double u = plane.counts[0], v = plane.counts[1];
  const double factor = std::sqrt(static_cast<double>(most) / (u * v));
  // A count below 1 leaves the other one all the room.
  const double nu =
      std::min(std::max(1.0, std::floor(u * factor)), static_cast<double>(most));
  const double nv = std::min(std::floor(static_cast<double>(most) / nu), v);
  return '[' + std::to_string(static_cast<std::int64_t>(nu)) + ", " +
         std::to_string(static_cast<std::int64_t>(nv)) + ']';
}

}  // namespace

std::string too_many_samples(std::int64_t count, std::int64_t most) {
  return grouped(count) + " samples would need about " + memory(count) + "; at most " +
         grouped(most);
}

std::string too_many_samples(const SampleSet& set, std::int64_t most) {
  const std::string text = too_many_samples(sample_count(set), most);
  if (const auto* volume = std::get_if<VolumeSampling>(&set.shape))
    return text + ": use step " + fitting_step(*volume, most) + " or coarser";
  if (const auto* plane = std::get_if<PlaneSampling>(&set.shape))
    return text + ": use counts " + fitting_counts(*plane, most) + " or fewer";
  const auto* path = std::get_if<PathSampling>(&set.shape);
  if (path && path->step) {
    const double factor =
        static_cast<double>(sample_count(set) - 1) / static_cast<double>(most - 1);
    return text + ": use step " + shortest(rounded_up(*path->step * factor)) +
           " or coarser";
  }
  if (path && path->count) return text + ": use count " + grouped(most) + " or fewer";
  return text + ": keep fewer points";
}

}  // namespace delos
