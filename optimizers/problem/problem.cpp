#include "delos/optimize/problem.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "delos/device/faults.h"
#include "delos/field/adaptive.h"
#include "delos/model/infinity.h"
#include "delos/model/metric_expression.h"
#include "delos/scene/definition.h"
#include "delos/steady/steady_solver.h"
#include "problem/guess.h"
#include "problem/problem_state.h"
#include "problem/reduce.h"

namespace delos {
namespace {

/// What is left of a rig where nobody looks.
class SeesNothing final : public Device {
 public:
  bool observe(const Target&, Observation&) const override { return false; }
};

/// What a sample costs, in units of the guess, where no guess can help.
constexpr double kBlindPenalty = 1e3;

/// How much of what is known at a pose is the guess, squared:
///
///     w² with w = σ²/(σ² + guess²),   σ = eigmax
///
/// about 1 where nobody sees, 1e-8 where devices know a hundred times as much.
struct BlindShare {
  BlindShare(double sigma, double guess) {
    const double u = sigma * sigma, g = guess * guess, w = u / (u + g);
    value = w * w;
    slope = 4 * w * sigma * g / ((u + g) * (u + g));
  }
  double value, slope;  // ∂value/∂σ
};

/// What a limit is where edges are soft: of a count, half a device short of it.
double soft_limit(const Metric& metric, double limit) {
  return metric.kind == MetricKind::coverage ? std::ceil(limit) - 0.5 : limit;
}

}  // namespace

bool Score::feasible() const {
  return std::isfinite(objective) &&
         std::all_of(slacks.begin(), slacks.end(), [](double s) { return s >= 0; });
}

std::size_t Problem::State::metric_index(const std::string& name, bool plain) {
  const auto metric = std::get<Metric>(
      parse_metric(name.empty() ? scene().metric : name, known_metrics(scene())));
  plain = plain || !metric.monotone;
  for (std::size_t m = 0; m < metrics.size(); ++m)
    if (metrics[m].metric.name == metric.name && metrics[m].plain == plain) return m;
  metrics.push_back({metric, plain});
  return metrics.size() - 1;
}

void Problem::State::read_objective() {
  std::vector<ObjectiveTerm> all = scene().objective.terms;
  if (all.empty()) {
    all.emplace_back();
    const std::size_t own = metric_index("");
    all.front().maximize = metrics[own].metric.larger_is_better;
  }
  // Where solids are is asked once: searches seldom move them.
  std::vector<unsigned char> inside;
  if (nominal.system.in_world.triangles() > 0) {
    const auto coverage =
        std::get<Metric>(parse_metric("coverage", known_metrics(scene())));
    inside = evaluate_field(nominal.system, samples.samples, scene().orientations,
                            coverage, {.threads = options.threads})
                 .inside;
  }
  for (const ObjectiveTerm& term : all) {
    const std::size_t m =
        metric_index(term.metric, term.reduction == Reduction::fraction);
    const Metric& metric = metrics[m].metric;
    const double sign = metric.larger_is_better ? -1 : 1;
    terms.push_back({term, sign * soft_limit(metric, term.limit), m, sign,
                     term_weights(term, scene(), samples, inside)});
    terms.back().term.limit = sign * term.limit;
    if (!metric.monotone && !sight_metric) sight_metric = metric_index("eigmax");
  }
  for (std::size_t c = 0; c < scene().constraints.size(); ++c) {
    const auto* keep = std::get_if<KeepMetric>(&scene().constraints[c].what);
    if (!keep) continue;
    MetricLimit limit{c, metric_index(keep->metric), keep->limit, keep->limit, 1, {}};
    const Metric& metric = metrics[limit.metric].metric;
    limit.soft_limit = soft_limit(metric, keep->limit);
    if (metric.larger_is_better) limit.sign = -1;
    for (std::size_t i = 0; i < samples.set.size(); ++i) {
      const bool in =
          keep->in.empty() || scene().samples[samples.set[i]].name == keep->in;
      if (in && (inside.empty() || !inside[i])) limit.samples.push_back(i);
    }
    if (limit.samples.empty())
      throw std::invalid_argument("constraint " + scene().constraints[c].name +
                                  " has no sample outside solids");
    metric_limits.push_back(std::move(limit));
  }
}

void Problem::State::read_limits() {
  limits = geometry.limits();
  for (const MetricLimit& limit : metric_limits)
    limits.push_back({limit.constraint, limit.unit()});
}

void Problem::State::build(std::span<const double> x) {
  design.set(x);
  System& last = nominal.system;
  last = build_system(scene(), plugins, last.devices.empty() ? nullptr : &last);
  if (guess > 0) last.prior = guess_information(last, guess);
}

/// The field of the first term's metric over a box at the design of which the octree is
/// asked for, with about as many nodes as samples are.
Field Problem::State::octree(AdaptiveSampling box) {
  build(options.octree_of);
  const auto& terms = scene().objective.terms;
  const std::string name = terms.empty() ? "" : terms.front().metric;
  const auto metric = std::get<Metric>(
      parse_metric(name.empty() ? scene().metric : name, known_metrics(scene())));
  if (options.samples > 0) {
    const auto most =
        static_cast<std::int64_t>(options.samples * scene().orientations.rpy.size());
    box.evaluations = std::min(box.evaluations.value_or(most), most);
  }
  box.seconds.reset();  // the same octree at any speed
  AdaptiveOptions adaptive;
  adaptive.field.threads = options.threads;
  adaptive.held_back = adaptive.spread = 0;
  return evaluate_adaptive(nominal.system, box, scene().orientations, metric, adaptive)
      .field();
}

/// Try each variable once.
void Problem::State::find_touched() {
  const System& system = nominal.system;
  const std::vector<double>& x = design.start();
  for (std::size_t v = 0; v < design.size(); ++v) {
    design.set(x);
    design.set(v, x[v] + (x[v] > 0.5 ? -1e-3 : 1e-3));
    const System moved = build_system(scene(), plugins, &system);
    Touched what;
    what.all = !(moved.motion == system.motion) || moved.markers != system.markers ||
               moved.occluders != system.occluders;
    for (std::size_t i = 0; i < system.devices.size(); ++i) {
      const PlacedDevice &a = system.devices[i], &b = moved.devices[i];
      if (a.period != b.period || a.phase != b.phase || a.exposure != b.exposure)
        what.all = true;
      const bool elsewhere = !(a.mount == b.mount);
      if (elsewhere && !a.carried()) what.poses.push_back(i);
      if (!(a.params == b.params) || (elsewhere && a.carried()))
        what.layers.push_back(i);
    }
    if (slope_problem.empty()) slope_problem = adjoint_problem(moved);
    touched.push_back(std::move(what));
  }
  design.set(x);
}

double Problem::State::objective(const FieldValues& values, std::optional<double> width,
                                 FieldValues* slopes) const {
  // Sharp where edges are: a trial's choice, from 0.07 to 3 times as much.
  std::optional<double> blur;
  if (width) blur = std::min(1.0, 2 * *width);
  double sum = 0;
  std::vector<double> costs, of_term;
  for (const Term& t : terms) {
    const bool fraction = t.term.reduction == Reduction::fraction;
    const Metric& metric = metrics[t.metric].metric;
    const bool ends_at_0 = t.sign < 0 && !metric.expression;
    const double blind = fraction ? kInfinity : ends_at_0 ? 0 : kBlindPenalty * guess;
    costs = values[t.metric];
    for (double& c : costs) c = std::isfinite(c) ? t.sign * c : blind;
    // With the guess in it such a metric may look good where nobody sees.
    const bool lures = width && !metric.monotone;
    const auto share_at = [&](std::size_t i) {
      return BlindShare(values[*sight_metric][i], guess);
    };
    if (lures)
      for (std::size_t i = 0; i < costs.size(); ++i) {
        const double share = share_at(i).value;
        costs[i] += kBlindPenalty * guess * (std::isfinite(share) ? share : 1);
      }
    of_term.resize(slopes ? costs.size() : 0);
    ObjectiveTerm term = t.term;
    if (width) term.limit = t.soft_limit;
    sum += term.weight *
           reduce(term, costs, t.weights, blur, slopes ? of_term.data() : nullptr);
    for (std::size_t i = 0; i < of_term.size(); ++i) {
      if (std::isfinite(values[t.metric][i]))
        (*slopes)[t.metric][i] += term.weight * t.sign * of_term[i];
      if (lures && std::isfinite(values[*sight_metric][i]))
        (*slopes)[*sight_metric][i] +=
            term.weight * of_term[i] * kBlindPenalty * guess * share_at(i).slope;
    }
  }
  return sum;
}

/// What a metric costs where nothing but the guess is known.
double Problem::State::cost_of_guess(std::size_t m) const {
  System blind = nominal.system;
  blind.prior = guess_information(blind, guess);
  blind.devices.resize(1);
  blind.devices.front().device = std::make_shared<const SeesNothing>();
  blind.devices.front().mount = WorldMount{};
  Samples one;
  one.points = {samples.samples.points.front()};
  one.parts = {{"", 0, 1, ScatteredShape{}}};
  const Metric& metric = metrics[m].metric;
  const double value =
      evaluate_field(blind, one, scene().orientations, metric, field_options())
          .value.front();
  return metric.larger_is_better ? -value : value;
}

/// Where a limit is what counts, the guess alone misses it by far: a search must not
/// take what it doesn't see for kept.
void Problem::State::weaken_guess() {
  constexpr double kFar = 4;
  if (guess_information(nominal.system, guess) == 0) return;
  for (const Term& t : terms) {
    if (t.term.reduction != Reduction::fraction ||
        metrics[t.metric].metric.kind == MetricKind::coverage ||
        !metrics[t.metric].metric.monotone)
      continue;
    const double far = t.sign > 0 ? kFar * t.term.limit : t.term.limit / kFar;
    constexpr int kDoublings = 60;
    for (int i = 0; i < kDoublings && cost_of_guess(t.metric) < far; ++i) guess *= 2;
  }
}

void Problem::State::metric_slacks(const FieldValues& values, double* out) const {
  for (const MetricLimit& limit : metric_limits) {
    double worst = -kInfinity;
    for (const std::size_t i : limit.samples) {
      const double value = values[limit.metric][i];
      worst = std::max(worst, std::isfinite(value) ? limit.sign * value : kInfinity);
    }
    *out++ = limit.sign * limit.limit - worst;
  }
}

Problem::Problem(const Scene& scene, PluginRegistry& plugins,
                 const ProblemOptions& options)
    : state_(std::make_unique<State>(scene, plugins, options)) {
  State& s = *state_;
  if (scene.variables.empty())
    throw std::invalid_argument(
        "the scene has no variables; say what may change, for example\n"
        "variables:\n  - {path: \"devices.*.at.z\", lower: 0.5, upper: 3}");
  s.guess = scene.objective.guess;
  s.samples = search_samples(
      scene, options.samples,
      options.octree_of.empty() ? Octrees() : [&s](const AdaptiveSampling& box) {
        return s.octree(box);
      });
  s.build(s.design.start());
  if (s.guess == 0)
    s.guess = typical_guess(s.nominal.system, s.samples.samples, scene.orientations);
  s.read_objective();
  if (scene.objective.guess == 0) s.weaken_guess();
  s.nominal.system.prior = guess_information(s.nominal.system, s.guess);
  s.read_limits();
  s.read_robust();
  s.find_touched();
  // Beacons come into view and go at once, whatever the device's place.
  for (const Touched& what : s.touched)
    for (const std::size_t i : what.layers)
      if (s.nominal.system.devices[i].carried())
        s.slope_problem = "what " + s.nominal.system.devices[i].name +
                          " sees of beacons has no derivative here";
  std::vector<Metric> metrics;
  for (const AskedMetric& asked : s.metrics) {
    const Metric& metric = metrics.emplace_back(asked.metric);
    if (const std::string problem = metric_problem(s.nominal.system, metric);
        !problem.empty())
      throw std::invalid_argument(problem);
    if (reads(metric, MetricKind::coverage) &&
        scene.orientations.combine == OrientationRule::information)
      s.slope_problem =
          "coverage in any of several orientations has no derivative here";
    if (s.slope_problem.empty())
      s.slope_problem = delos::slope_problem(s.nominal.system, metric);
  }
  s.soft = std::make_unique<SoftField>(s.samples.samples, scene.orientations, metrics,
                                       options.threads);
}

Problem::~Problem() = default;

Design& Problem::design() { return state_->design; }
double Problem::guess() const { return state_->guess; }
const std::vector<Limit>& Problem::limits() const { return state_->limits; }
std::size_t Problem::samples() const { return state_->samples.set.size(); }
const std::string& Problem::slope_problem() const { return state_->slope_problem; }

Score Problem::score(std::span<const double> x) {
  State& s = *state_;
  Score score{kInfinity, std::vector<double>(s.limits.size(), -kInfinity)};
  try {
    s.build(x);
  } catch (const Unbuildable&) {
    return score;  // no such device, or no such place: as bad as can be
  }
  score.objective = s.robust_objective();
  s.geometry.slacks(s.scene(), score.slacks.data());
  // What a guess makes finite isn't kept.
  if (!s.metric_limits.empty())
    s.metric_slacks(s.hard_values(s.nominal, false),
                    score.slacks.data() + s.geometry.limits().size());
  return score;
}

std::vector<double> Problem::place_slacks(std::span<const double> x) {
  State& s = *state_;
  s.design.set(x);
  std::vector<double> slacks(s.geometry.limits().size(), -kInfinity);
  try {
    s.geometry.slacks(s.scene(), slacks.data());
  } catch (const Unbuildable&) {
    // A place that isn't there keeps nothing.
  }
  return slacks;
}

double Problem::plain_objective(std::span<const double> x) {
  State& s = *state_;
  s.build(x);
  return s.objective(s.hard_values(s.nominal, true), {}, nullptr);
}

double Problem::objective_without(std::span<const double> x, std::size_t device) {
  State& s = *state_;
  s.build(x);
  return s.objective(s.hard_values(s.nominal, true, device), {}, nullptr);
}

Field Problem::field(std::span<const double> x) {
  State& s = *state_;
  s.build(x);
  const auto metric =
      std::get<Metric>(parse_metric(s.scene().metric, known_metrics(s.scene())));
  System system = s.nominal.system;
  system.prior = 0;
  Field field = evaluate_field(system, all_samples(s.scene()), s.scene().orientations,
                               metric, {.threads = s.options.threads});
  field.scene = s.scene().name;
  return field;
}

}  // namespace delos
