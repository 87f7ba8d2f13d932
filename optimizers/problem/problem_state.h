// What a problem holds. Its scores stand in problem.cpp and withstanding.cpp, its
// slopes in problem_slopes.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "delos/field/soft_field.h"
#include "delos/optimize/problem.h"
#include "problem/deviation.h"
#include "problem/place_limits.h"
#include "problem/search_samples.h"

namespace delos {

/// A term of the objective, ready to be reduced: in costs, of which less is better.
struct Term {
  ObjectiveTerm term;  // its limit is one of costs
  double soft_limit;   // the same where edges are soft
  std::size_t metric;
  double sign;  // cost = sign · value
  std::vector<double> weights;
};

/// A metric that is asked for.
struct AskedMetric {
  Metric metric;
  /// Judged without the guess, as limits are: what no device sees meets none.
  bool plain = false;
};

/// A limit on a metric.
struct MetricLimit {
  std::size_t constraint;
  std::size_t metric;
  double limit;
  double soft_limit;  ///< the same where edges are soft
  double sign;        ///< 1: at most, −1: at least
  std::vector<std::size_t> samples;

  [[nodiscard]] double unit() const { return std::max(std::abs(limit), 1e-12); }
};

/// What a variable changes.
struct Touched {
  std::vector<std::size_t> poses, layers;  ///< devices that move; that are others
  bool all = false;                        ///< more than single devices
};

/// A system that is judged: the scene's own, or what a draw makes of it.
struct World {
  System system;
  std::vector<Deviation> deviations;  // one a device; none: the scene's
  std::optional<InformationLayers> layers;
};

/// By how much a limit is missed, softened, in its units; less than 0: kept.
/// @param width of the edges that the values are of; 0: what is at most 0 is kept
/// @param[out] slopes one a sample, or null
[[nodiscard]] double soft_miss(const MetricLimit& limit,
                               const std::vector<double>& values, double width,
                               double* slopes);

struct Problem::State {
  State(const Scene& scene, PluginRegistry& registry, const ProblemOptions& given)
      : plugins(registry), options(given), design(scene, registry), geometry(design) {}

  PluginRegistry& plugins;
  ProblemOptions options;
  Design design;
  GeometryLimits geometry;
  SearchSamples samples;
  std::vector<AskedMetric> metrics;
  std::vector<Term> terms;
  std::vector<MetricLimit> metric_limits;
  std::vector<Limit> limits;
  std::vector<Touched> touched;
  double guess = 0;                         // 0: not known yet
  std::optional<std::size_t> sight_metric;  // eigmax, where terms aren't monotone
  std::string slope_problem;
  std::vector<std::size_t> failing;  // devices of which one may fail
  World nominal;                     // as last built
  std::vector<World> drawn;          // what each draw makes of it; see draw()
  std::unique_ptr<SoftField> soft;
  FieldValues values;  // of the soft field last evaluated, of all devices

  [[nodiscard]] const Scene& scene() const { return design.scene(); }

  std::size_t metric_index(const std::string& name, bool plain = false);
  void read_objective();
  double cost_of_guess(std::size_t metric) const;
  void weaken_guess();
  void read_limits();
  void read_robust();
  Field octree(AdaptiveSampling box);
  void find_touched();
  void build(std::span<const double> x);
  void draw();
  [[nodiscard]] FieldOptions field_options() const {
    FieldOptions all;
    all.threads = options.threads;
    all.find_inside = false;
    return all;
  }

  const InformationLayers& layers(World& world, bool with_guess);
  FieldValues hard_values(World& world, bool with_guess,
                          std::optional<std::size_t> missing = {});
  double objective(const FieldValues& values, std::optional<double> width,
                   FieldValues* slopes) const;
  double hard_objective(World& world);
  double robust_objective();
  void metric_slacks(const FieldValues& values, double* out) const;
  double soft_objective(std::span<const double> x, const World& world, double width,
                        double* slope);
  double soft_robust_objective(std::span<const double> x, double width, double* slope);
  void soft_values(std::span<const double> x, double width, Score& out,
                   double* slope = nullptr);
  void chain(std::span<const double> x, const World& world,
             const std::vector<PoseSlope>& poses, double* out);
  void slopes_by_differences(std::span<const double> x, double width, double* slope,
                             double* slopes);
};

}  // namespace delos
