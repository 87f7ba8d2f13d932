#include "problem/search_samples.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace delos {
namespace {

/// Samples along the longest side of an adaptive box where all are wanted.
constexpr int kFine = 36;

/// Points that fill a box evenly: the R₃ sequence, x_k = frac(k/g, k/g², k/g³) with
/// g⁴ = g + 1. Source: Roberts (2018), The unreasonable effectiveness of quasirandom
/// sequences.
std::vector<Eigen::Vector3d> spread(const AdaptiveSampling& box, std::size_t count) {
  constexpr double kG = 1.2207440846057596;
  const Eigen::Array3d step(1 / kG, 1 / (kG * kG), 1 / (kG * kG * kG));
  std::vector<Eigen::Vector3d> points;
  for (std::size_t k = 1; k <= count; ++k) {
    const Eigen::Array3d x = 0.5 + static_cast<double>(k) * step;
    const Eigen::Array3d part = x - x.floor();
    points.emplace_back(box.min + (part * (box.max - box.min).array()).matrix());
  }
  return points;
}

std::vector<Eigen::Vector3d> grid(const AdaptiveSampling& box) {
  const double step = (box.max - box.min).maxCoeff() / kFine;
  return make_samples(
             {{"", VolumeSampling{box.min, box.max, Eigen::Vector3d::Constant(step)}}})
      .points;
}

/// `most` of n indices, spread over them without the period of a grid.
std::vector<std::size_t> thinned(std::size_t n, std::size_t most) {
  std::vector<std::size_t> chosen;
  if (most == 0 || n <= most) {
    for (std::size_t i = 0; i < n; ++i) chosen.push_back(i);
    return chosen;
  }
  constexpr double kGolden = 0.6180339887498949;
  std::vector<bool> taken(n);
  for (std::size_t k = 0; chosen.size() < most; ++k) {
    const double x = 0.5 + static_cast<double>(k) * kGolden;
    const auto i =
        static_cast<std::size_t>((x - std::floor(x)) * static_cast<double>(n));
    if (taken[i]) continue;
    taken[i] = true;
    chosen.push_back(i);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

/// Samples of one set, and how much each counts; no weights: all alike.
struct SetSamples {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> weights;
};

SetSamples samples_of(const SampleSet& set, std::size_t most, const Octrees& octrees) {
  const auto* box = std::get_if<AdaptiveSampling>(&set.shape);
  if (!box) return {make_samples({set}).points, {}};
  if (!octrees) return {most > 0 ? spread(*box, most) : grid(*box), {}};
  Field field = octrees(*box);
  return {std::move(field.samples.points), std::move(field.weight)};
}

/// Whether the objective or a limit looks at a set.
bool matters(const std::string& name, const Scene& scene) {
  const auto& terms = scene.objective.terms;
  return terms.empty() ||
         std::any_of(terms.begin(), terms.end(),
                     [&](const ObjectiveTerm& term) {
                       return term.over.empty() ||
                              std::any_of(term.over.begin(), term.over.end(),
                                          [&](const WeightedSet& set) {
                                            return set.name == name && set.weight > 0;
                                          });
                     }) ||
         std::any_of(scene.constraints.begin(), scene.constraints.end(),
                     [&](const ConstraintEntry& constraint) {
                       const auto* keep = std::get_if<KeepMetric>(&constraint.what);
                       return keep && (keep->in.empty() || keep->in == name);
                     });
}

/// How many samples a set may keep, so that all keep `most`: small ones, which stand
/// for what matters most, keep all theirs. 0: no limit.
std::size_t fair_share(const std::vector<SetSamples>& sets, std::size_t most) {
  std::vector<std::size_t> sizes;
  for (const SetSamples& set : sets)
    if (set.weights.empty() && !set.points.empty()) sizes.push_back(set.points.size());
  std::sort(sizes.begin(), sizes.end());
  std::size_t left = most;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const std::size_t share = left / (sizes.size() - k);
    if (sizes[k] > share) return std::max<std::size_t>(share, most > 0 ? 1 : 0);
    left -= sizes[k];
  }
  return 0;
}

}  // namespace

SearchSamples search_samples(const Scene& scene, std::size_t most,
                             const Octrees& octrees) {
  std::vector<SetSamples> sets;
  for (const SampleSet& set : scene.samples)
    sets.push_back(matters(set.name, scene) ? samples_of(set, most, octrees)
                                            : SetSamples());
  const std::size_t share = fair_share(sets, most);
  SearchSamples out;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const std::size_t n = sets[s].points.size();
    if (n == 0) continue;
    // Nodes stay together.
    const bool even = sets[s].weights.empty();
    const auto chosen = thinned(n, even ? share : 0);
    out.samples.parts.push_back({scene.samples[s].name, out.samples.points.size(),
                                 chosen.size(), ScatteredShape{}});
    for (const std::size_t i : chosen) {
      out.samples.points.push_back(sets[s].points[i]);
      out.set.push_back(s);
      out.multiplicity.push_back(even ? static_cast<double>(n) /
                                            static_cast<double>(chosen.size())
                                      : sets[s].weights[i]);
    }
  }
  return out;
}

Samples all_samples(const Scene& scene) {
  Samples all;
  for (const SampleSet& set : scene.samples) {
    const SetSamples own = samples_of(set, 0, {});
    all.parts.push_back(
        {set.name, all.points.size(), own.points.size(), ScatteredShape{}});
    all.points.insert(all.points.end(), own.points.begin(), own.points.end());
  }
  return all;
}

std::vector<double> term_weights(const ObjectiveTerm& term, const Scene& scene,
                                 const SearchSamples& samples,
                                 const std::vector<unsigned char>& inside) {
  std::vector<double> weights(samples.set.size());
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    double weight = term.over.empty() ? 1 : 0;
    for (const WeightedSet& set : term.over)
      if (set.name == scene.samples[samples.set[i]].name) weight = set.weight;
    if (!inside.empty() && inside[i]) weight = 0;
    weights[i] = weight * samples.multiplicity[i];
    sum += weights[i];
  }
  if (!(sum > 0))
    throw std::invalid_argument("the objective has no sample outside solids");
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace delos
