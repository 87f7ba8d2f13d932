#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "delos/model/metric.h"
#include "delos/optimize/tradeoff.h"
#include "delos/scene/definition.h"

namespace delos {
namespace {

ConstraintEntry& named(Scene& scene, const std::string& name) {
  std::string known;
  for (ConstraintEntry& entry : scene.constraints) {
    if (entry.name == name) return entry;
    known += (known.empty() ? "" : ", ") + entry.name;
  }
  throw std::invalid_argument(
      "there is no constraint '" + name + "'; " +
      (known.empty() ? "the scene has none" : "there are " + known));
}

struct LimitOf {
  double& operator()(KeepInside& k) const { return k.margin; }
  double& operator()(KeepApart& k) const { return k.distance; }
  double& operator()(KeepTilt& k) const { return k.angle; }
  double& operator()(KeepClear& k) const { return k.distance; }
  double& operator()(KeepSum& k) const { return k.limit; }
  double& operator()(KeepMetric& k) const { return k.limit; }
};

/// Whether a larger limit asks for more.
bool is_lower_bound(const ConstraintEntry& entry, const Scene& scene) {
  if (const auto* keep = std::get_if<KeepMetric>(&entry.what))
    return std::get<Metric>(parse_metric(keep->metric, known_metrics(scene)))
        .larger_is_better;
  return !std::holds_alternative<KeepTilt>(entry.what) &&
         !std::holds_alternative<KeepSum>(entry.what);
}

FrontPoint searched(Scene scene, const std::string& constraint, double limit,
                    bool lower_bound, PluginRegistry& plugins,
                    const OptimizeOptions& options) {
  constraint_limit(scene, constraint) = limit;
  OptimizeResult found = optimize(scene, plugins, options);
  FrontPoint point;
  point.limit = limit;
  point.objective = found.best.objective;
  point.kept = found.best.feasible();
  for (const ConstraintReport& report : found.constraints)
    if (report.name == constraint)
      point.used = lower_bound ? limit + report.slack : limit - report.slack;
  point.scene = std::move(found.scene);
  return point;
}

/// Less by more than rounding.
bool less(double a, double b) {
  constexpr double kRounding = 1e-6;
  return a < b - kRounding * std::max(std::abs(a), std::abs(b));
}

void mark_dominated(std::vector<FrontPoint>& points, bool lower_bound) {
  const auto cost = [&](const FrontPoint& p) { return lower_bound ? -p.used : p.used; };
  for (FrontPoint& p : points) {
    p.dominated = std::any_of(points.begin(), points.end(), [&](const FrontPoint& q) {
      return q.kept && !less(p.objective, q.objective) && !less(cost(p), cost(q)) &&
             (less(q.objective, p.objective) || less(cost(q), cost(p)));
    });
  }
}

}  // namespace

double& constraint_limit(Scene& scene, const std::string& constraint) {
  return std::visit(LimitOf(), named(scene, constraint).what);
}

std::vector<FrontPoint> search_front(const Scene& given, PluginRegistry& plugins,
                                     const std::string& constraint,
                                     std::vector<double> levels,
                                     const OptimizeOptions& options,
                                     const SearchesDone& progress) {
  Scene scene = with_guess(given, plugins);
  const bool lower_bound = is_lower_bound(named(scene, constraint), scene);
  std::sort(levels.begin(), levels.end());
  if (!lower_bound) std::reverse(levels.begin(), levels.end());

  std::vector<FrontPoint> points;
  std::size_t done = 0, of = levels.size();
  const auto tell = [&] {
    if (progress) progress(done, of);
  };
  const auto stopped = [&] { return options.cancel && options.cancel->load(); };
  for (const double level : levels) {
    tell();
    points.push_back(searched(scene, constraint, level, lower_bound, plugins, options));
    if (stopped()) return points;
    ++done;
    if (points.back().kept) scene = points.back().scene;
  }
  for (std::size_t k = points.size() - 1; k-- > 0 && !stopped();) {
    const FrontPoint& tighter = points[k + 1];
    if (!tighter.kept || (points[k].kept && points[k].objective <= tighter.objective))
      continue;
    ++of;
    tell();
    points[k] = searched(tighter.scene, constraint, points[k].limit, lower_bound,
                         plugins, options);
    ++done;
  }
  mark_dominated(points, lower_bound);
  return points;
}

}  // namespace delos
