#include "delos/field/adaptive.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include "delos/parallel/each.h"
#include "field/adaptive_state.h"
#include "field/volume_points.h"
#include "rig/sight.h"

namespace delos {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

const char* to_string(AdaptiveStop stop) {
  switch (stop) {
    case AdaptiveStop::tolerance:
      return "tolerance";
    case AdaptiveStop::depth:
      return "depth";
    case AdaptiveStop::evaluations:
      return "evaluations";
    case AdaptiveStop::deadline:
      return "deadline";
    case AdaptiveStop::cancelled:
      return "cancelled";
  }
  return "";
}

AdaptiveField::State::State(const System& s, const AdaptiveSampling& a,
                            const Orientations& o, const Metric& m,
                            const AdaptiveOptions& given)
    : system(s),
      sampling(a),
      orientations(o),
      turns(rotations(o)),
      metric(m),
      options(given),
      threads(thread_count(given.field.threads)),
      solver(make_steady_solver(system, given.field.solver)),
      sightings(system),
      tree({a.min, a.max}, a.depth),
      views(system, sightings, turns),
      store(system, sightings, turns),
      between(system, sightings, turns, tree, views, store) {}

/// Volume that stands for each node: an eighth of every leaf that it is a corner of.
Field AdaptiveField::State::node_field() const {
  Field f;
  f.metric = metric.name;
  f.unit = metric.unit;
  f.larger_is_better = metric.larger_is_better;
  f.definition = definition_of(system);
  f.threads = threads;
  f.evaluations = evaluations;
  f.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  f.evaluated = store.nodes();
  f.inside = inside;
  f.weight.assign(store.nodes(), 0);
  OctreeShape shape;
  if (store.nodes() == 0) return f;
  for (const Octree::Index leaf : tree.leaves()) {
    const Octree::Corners corners = tree.corners(leaf);
    const double part = tree.box_of(leaf).volume() / 8;
    for (const Octree::Index n : corners) f.weight[n] += part;
    shape.cells.push_back(corners);
    shape.levels.push_back(tree.cells()[leaf].level);
  }
  for (std::size_t n = 0; n < store.nodes(); ++n) {
    f.samples.points.push_back(tree.position(static_cast<Octree::Index>(n)));
    f.value.push_back(value[n].value);
    f.observable.push_back(value[n].observable);
    f.lost.push_back(static_cast<unsigned char>(value[n].lost));
  }
  f.samples.parts.push_back({"", 0, store.nodes(), std::move(shape)});
  return f;
}

/// The 95th percentile of |interpolated/true − 1| at random points.
double AdaptiveField::State::held_back_error() {
  std::mt19937_64 random(20070501);
  std::uniform_real_distribution<double> uniform(0, 1);
  const Eigen::Vector3d size = sampling.max - sampling.min;
  Samples points;
  std::vector<Query> queries;
  for (int i = 0; i < options.held_back; ++i) {
    Eigen::Vector3d p = sampling.min;
    for (int k = 0; k < 3; ++k) p(k) += uniform(random) * size(k);
    if (inside_solid(system, p)) continue;
    points.points.push_back(p);
    queries.push_back({tree.leaf_at(p), p});
  }
  if (queries.empty()) return 0;
  const Field truth =
      evaluate_field(system, points, orientations, metric,
                     {.solver = options.field.solver, .threads = threads});
  const std::vector<PoseValue> read = values_at(queries, DoubtRule::nearest);
  evaluations += truth.evaluations;
  std::vector<double> off;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const double a = read[i].value, b = truth.value[i];
    const bool both = std::isfinite(a) && std::isfinite(b) && b != 0;
    off.push_back(a == b ? 0 : both ? std::min(1.0, std::abs(a / b - 1)) : 1);
  }
  const std::size_t at = off.size() * 95 / 100;
  std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(at),
                   off.end());
  return off[at];
}

/// Whether the edge of a view, a shadow or a solid may cross a cell.
bool AdaptiveField::State::has_edge(Octree::Index cell) const {
  for (std::size_t t = 0; t < turns.size(); ++t) {
    for (std::size_t s = 0; s < sightings.all.size(); ++s) {
      if (views.at(cell, t, s).view == View::crossing || views.in_doubt(cell, t, s))
        return true;
    }
  }
  const Eigen::AlignedBox3d box = tree.box_of(cell);
  return system.in_world.triangles() > 0 &&
         system.in_world.touches_shaft(box.center(), box);
}

/// Values for statistics over the volume; those of the nodes are denser where the field
/// bends, and never refined along the edges of views.
std::shared_ptr<const Field> AdaptiveField::State::spread_field() {
  VolumePoints spread = volume_points(
      tree, [this](Octree::Index c) { return has_edge(c); }, options.spread,
      options.seed);
  const auto asked = static_cast<std::int64_t>(spread.points.size() * turns.size());
  if (sampling.evaluations && asked > *sampling.evaluations / 2) return nullptr;
  Samples samples;
  samples.points = std::move(spread.points);
  samples.parts.push_back({"", 0, samples.points.size(), ScatteredShape{}});
  Field f = evaluate_field(system, samples, orientations, metric,
                           {.solver = options.field.solver,
                            .threads = threads,
                            .cancel = options.field.cancel,
                            .find_inside = false});
  if (f.cancelled) return nullptr;
  evaluations += f.evaluations;
  f.weight = std::move(spread.weight);
  if (system.in_world.triangles() > 0)
    for (const Eigen::Vector3d& p : f.samples.points)
      f.inside.push_back(inside_solid(system, p));
  return std::make_shared<const Field>(std::move(f));
}

Field AdaptiveField::State::read(const Samples& samples, ShadowEdges edges) const {
  std::vector<Query> queries;
  queries.reserve(samples.points.size());
  for (const Eigen::Vector3d& p : samples.points)
    queries.push_back({tree.leaf_at(p), p});
  const auto begin = Clock::now();
  const std::vector<PoseValue> read = values_at(
      queries, edges == ShadowEdges::exact ? DoubtRule::exact : DoubtRule::nearest);
  Field f;
  f.metric = metric.name;
  f.unit = metric.unit;
  f.larger_is_better = metric.larger_is_better;
  f.definition = definition_of(system);
  f.threads = threads;
  f.samples = samples;
  f.evaluated = queries.size();
  for (const PoseValue& v : read) {
    f.value.push_back(v.value);
    f.observable.push_back(v.observable);
    f.lost.push_back(static_cast<unsigned char>(v.lost));
  }
  f.inside = inside_solids(system, samples);
  f.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return f;
}

void AdaptiveField::State::finish() {
  between.conform();
  std::optional<double> off;
  if (options.held_back > 0 && !cancelled() && store.nodes() > 0)
    off = held_back_error();
  std::shared_ptr<const Field> spread;
  if (options.spread > 0 && !cancelled() && store.nodes() > 0) spread = spread_field();
  field = node_field();
  field.spread = std::move(spread);
  field.discretization_error = off;
  field.cancelled = report.stop == AdaptiveStop::cancelled;
  report.nodes = store.nodes();
  report.rays = store.rays();
  report.rays_saved = store.rays_saved();
  for (const Octree::Index leaf : tree.leaves()) {
    if (store.nodes() > 0) ++report.leaves;
    report.levels = std::max(report.levels, tree.cells()[leaf].level);
  }
}

AdaptiveField::AdaptiveField(std::unique_ptr<State> state) : state_(std::move(state)) {}
AdaptiveField::AdaptiveField(AdaptiveField&&) noexcept = default;
AdaptiveField& AdaptiveField::operator=(AdaptiveField&&) noexcept = default;
AdaptiveField::~AdaptiveField() = default;

const Field& AdaptiveField::field() const { return state_->field; }
const AdaptiveReport& AdaptiveField::report() const { return state_->report; }

Field AdaptiveField::read(const Samples& samples, ShadowEdges edges) const {
  return state_->read(samples, edges);
}

AdaptiveField evaluate_adaptive(const System& system, const AdaptiveSampling& sampling,
                                const Orientations& orientations, const Metric& metric,
                                const AdaptiveOptions& options) {
  if (const std::string problem = metric_problem(system, metric); !problem.empty()) {
    throw std::invalid_argument(problem);
  }
  auto state = std::make_unique<AdaptiveField::State>(system, sampling, orientations,
                                                      metric, options);
  state->grow();
  state->finish();
  return AdaptiveField(std::move(state));
}

}  // namespace delos
