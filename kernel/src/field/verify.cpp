#include "delos/field/verify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "delos/field/adaptive.h"

namespace delos {
namespace {

constexpr int kPoints = 4000;

/// Random places, as parts of a set's extent along its axes and in the world.
struct Places {
  std::vector<Eigen::Vector3d> parts;  ///< in [0, 1]
  Samples samples;
};

template <class At>
Places random_places(At&& at) {
  std::mt19937_64 random(20070502);
  std::uniform_real_distribution<double> uniform(0, 1);
  Places places;
  for (int i = 0; i < kPoints; ++i) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    places.parts.emplace_back(x, y, z);
    places.samples.points.push_back(at(places.parts.back()));
  }
  places.samples.parts.push_back({"", 0, kPoints, ScatteredShape{}});
  return places;
}

/// Linear interpolation over a grid of counts nodes at a place in steps from its
/// corner.
double interpolate(const Field& field, const Eigen::Vector3i& counts,
                   const Eigen::Vector3d& at) {
  Eigen::Vector3i base;
  Eigen::Vector3d part;
  for (int i = 0; i < 3; ++i) {
    base(i) = std::clamp(static_cast<int>(at(i)), 0, std::max(0, counts(i) - 2));
    part(i) = counts(i) > 1 ? at(i) - base(i) : 0;
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::size_t index = 0, stride = 1;
    for (int i = 0; i < 3; ++i) {
      const int up = corner >> i & 1;
      weight *= up ? part(i) : 1 - part(i);
      index += stride * static_cast<std::size_t>(std::min(base(i) + up, counts(i) - 1));
      stride *= static_cast<std::size_t>(counts(i));
    }
    if (weight != 0) sum += weight * field.value[index];
  }
  return sum;
}

/// Root mean square of read − solved, where both are finite.
double difference(const std::vector<double>& read, const std::vector<double>& solved) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (!std::isfinite(read[i]) || !std::isfinite(solved[i])) continue;
    sum += (read[i] - solved[i]) * (read[i] - solved[i]);
    ++count;
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count))
                   : std::numeric_limits<double>::quiet_NaN();
}

double order(const Resolution& coarse, const Resolution& fine) {
  return std::log(coarse.error / fine.error) / std::log(coarse.spacing / fine.spacing);
}

/// Evaluates one sampling at several resolutions.
struct Verify {
  const System& system;
  const Orientations& orientations;
  const Metric& metric;
  const FieldOptions& options;

  [[nodiscard]] Field evaluate(const Samples& samples) const {
    return evaluate_field(system, samples, orientations, metric, options);
  }

  std::vector<Resolution> operator()(const VolumeSampling& volume) const {
    const Places places = random_places([&](const Eigen::Vector3d& t) {
      return Eigen::Vector3d(volume.min + t.cwiseProduct(last(volume) - volume.min));
    });
    const Field solved = evaluate(places.samples);
    std::vector<Resolution> all;
    for (const int factor : {4, 2, 1}) {
      VolumeSampling coarse = volume;
      coarse.max = last(volume);
      coarse.step *= factor;
      const Samples grid = make_samples({{"", coarse}});
      const auto shape = std::get<GridShape>(grid.parts.front().shape);
      const Eigen::Vector3i counts = shape.counts.cast<int>();
      if ((counts.array() < 2).any() && factor == 4) return {};
      const Field field = evaluate(grid);
      if (field.cancelled) return {};
      std::vector<double> read;
      for (const Eigen::Vector3d& p : places.samples.points) {
        read.push_back(
            interpolate(field, counts, (p - shape.origin).cwiseQuotient(shape.step)));
      }
      all.push_back(
          {coarse.step.maxCoeff(), field.evaluations, difference(read, solved.value)});
    }
    return all;
  }

  /// The far corner of the coarsest grid, so that all three cover the same.
  static Eigen::Vector3d last(const VolumeSampling& volume) {
    Eigen::Vector3d far = volume.min;
    for (int i = 0; i < 3; ++i) {
      const double steps = (volume.max(i) - volume.min(i)) / volume.step(i);
      far(i) += 4 * std::floor(steps / 4 + 1e-9) * volume.step(i);
    }
    return far;
  }

  std::vector<Resolution> operator()(const PlaneSampling& plane) const {
    const int fours = std::min(plane.counts[0] - 1, plane.counts[1] - 1) / 4;
    if (fours < 1) return {};
    const Places places = random_places([&](const Eigen::Vector3d& t) {
      return Eigen::Vector3d(plane.origin + t.x() * plane.u + t.y() * plane.v);
    });
    const Field solved = evaluate(places.samples);
    std::vector<Resolution> all;
    for (const int factor : {4, 2, 1}) {
      PlaneSampling coarse = plane;
      coarse.counts = (plane.counts.array() - 1) / factor + 1;
      const Field field = evaluate(make_samples({{"", coarse}}));
      if (field.cancelled) return {};
      const Eigen::Vector3i counts(coarse.counts[0], coarse.counts[1], 1);
      std::vector<double> read;
      for (const Eigen::Vector3d& t : places.parts) {
        read.push_back(interpolate(
            field, counts, {t.x() * (counts.x() - 1), t.y() * (counts.y() - 1), 0}));
      }
      const double spacing = std::max(plane.u.norm() / (counts.x() - 1),
                                      plane.v.norm() / (counts.y() - 1));
      all.push_back({spacing, field.evaluations, difference(read, solved.value)});
    }
    return all;
  }

  std::vector<Resolution> operator()(const AdaptiveSampling& adaptive) const {
    const Eigen::Vector3d size = adaptive.max - adaptive.min;
    const Places places = random_places([&](const Eigen::Vector3d& t) {
      return Eigen::Vector3d(adaptive.min + t.cwiseProduct(size));
    });
    const Field solved = evaluate(places.samples);
    std::vector<Resolution> all;
    for (const int coarser : {2, 1, 0}) {
      AdaptiveSampling coarse = adaptive;
      coarse.tolerance *= std::pow(4, coarser);
      coarse.depth = std::max(1, adaptive.depth - coarser);
      AdaptiveOptions adaptive_options;
      adaptive_options.field = options;
      adaptive_options.held_back = adaptive_options.spread = 0;
      const AdaptiveField field =
          evaluate_adaptive(system, coarse, orientations, metric, adaptive_options);
      if (field.field().cancelled) return {};
      const auto evaluations = static_cast<double>(field.field().evaluations);
      all.push_back({std::cbrt(size.prod() / evaluations), field.field().evaluations,
                     difference(field.read(places.samples).value, solved.value)});
    }
    return all;
  }

  template <class Other>
  std::vector<Resolution> operator()(const Other&) const {
    return {};
  }
};

}  // namespace

Verification verify_sampling(const System& system, const SampleSet& set,
                             const Orientations& orientations, const Metric& metric,
                             const FieldOptions& options) {
  Verification v;
  v.resolutions = std::visit(Verify{system, orientations, metric, options}, set.shape);
  if (v.resolutions.size() == 3) {
    v.first_order = order(v.resolutions[0], v.resolutions[1]);
    v.second_order = order(v.resolutions[1], v.resolutions[2]);
  }
  return v;
}

}  // namespace delos
