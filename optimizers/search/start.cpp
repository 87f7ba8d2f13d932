#include "search/start.h"

#include <algorithm>
#include <cmath>

#include "delos/model/infinity.h"

namespace delos {
namespace {

/// Limits are searched with this room, in units of their scale, so that they hold.
constexpr double kLimitRoom = 1e-6;
/// In them, what solvers are told of a limit that is missed without measure.
constexpr double kFar = 1e3;

/// How much a score misses its limits, in units of their scales; 0: not at all.
double violation(const Score& score, const std::vector<Limit>& limits) {
  double worst = 0;
  for (std::size_t i = 0; i < limits.size(); ++i)
    worst = std::max(worst, -score.slacks[i] / limits[i].scale);
  return worst;
}

}  // namespace

Workplace::Workplace(const Scene& scene, PluginRegistry& plugins,
                     const ProblemOptions& options)
    : problem(scene, plugins, options),
      scene_(scene),
      plugins_(plugins),
      options_(options),
      coarse_options_(options),
      adaptive_(std::any_of(
          scene.samples.begin(), scene.samples.end(), [](const SampleSet& set) {
            return std::holds_alternative<AdaptiveSampling>(set.shape);
          })) {
  coarse_options_.samples = std::max<std::size_t>(options.samples / 4, 64);
  if (!adaptive_) coarse_.emplace(scene, plugins, coarse_options_);
}

Problem& Workplace::of_stage(double width, const std::vector<double>& from) {
  const bool coarse = width >= kCoarseWidth;
  if (!adaptive_) return coarse ? *coarse_ : problem;
  if (!std::isfinite(problem.score(from).objective)) return problem;  // has no field
  ProblemOptions options = coarse ? coarse_options_ : options_;
  options.octree_of = from;
  frozen_.emplace(scene_, plugins_, options);
  return *frozen_;
}

bool better(const Score& a, const Score& b, const std::vector<Limit>& limits) {
  if (!std::isfinite(a.objective)) return false;
  const double va = violation(a, limits), vb = violation(b, limits);
  if (va > 0 || vb > 0) return va != vb ? va < vb : a.objective < b.objective;
  return a.objective < b.objective;
}

template <class Evaluate>
EvaluationRecord Start::remembered(std::span<const double> x, bool slopes,
                                   Evaluate&& evaluate) {
  EvaluationRecord record;
  record.score.slacks.resize(limits().size());
  if (slopes) {
    record.slope.resize(x.size());
    record.slopes.resize(limits().size() * x.size());
  }
  const EvaluationKey key{index_, number_++};
  if (!options_.ledger || !options_.ledger->recall(key, x, record)) {
    evaluate(record);
    if (options_.ledger) options_.ledger->remember(key, x, record);
  }
  shared_.count(slopes);
  return record;
}

Score Start::hard(std::span<const double> x) {
  return remembered(x, false,
                    [&](EvaluationRecord& r) { r.score = at_->problem.score(x); })
      .score;
}

EvaluationRecord Start::soft(std::span<const double> x, double width) {
  return remembered(x, true, [&](EvaluationRecord& r) {
    r.width = width;
    r.score = stage_->score_with_slopes(x, width, r.slope.data(), r.slopes.data());
  });
}

void Start::note() {
  if (best_score_.feasible()) shared_.found(best_score_.objective);
}

void Start::take(std::span<const double> x, const Score& score) {
  if (!better(score, best_score_, limits())) return;
  best_.assign(x.begin(), x.end());
  best_score_ = score;
  note();
}

void Start::explore(Workplace& at, const std::vector<double>& from) {
  if (index_ > 0 && cancelled()) return;  // the first one is what there was
  at_ = &at;
  x_ = best_ = from;
  best_score_ = hard(from);
  note();
  if (plan_.traits.slopes)
    run_stages(0, kExploring);
  else if (!cancelled())
    (void)run_stage(from, 0, plan_.per_start);
}

void Start::finish(Workplace& at) {
  if (!explored()) return;
  at_ = &at;
  if (plan_.traits.slopes) run_stages(kExploring, static_cast<int>(std::size(kWidths)));
}

void Start::run_stages(int first, int end) {
  const int each = plan_.per_start / static_cast<int>(std::size(kWidths));
  for (int stage = first; stage < end && !cancelled(); ++stage) {
    stage_ = &at_->of_stage(kWidths[stage], x_);
    x_ = run_stage(x_, kWidths[stage], each);
    // Uninterrupted, the stage goes on: its next evaluation is another one.
    take(x_, cancelled() ? at_->problem.score(x_) : hard(x_));
  }
}

/// @returns the best point of the stage by what the stage minimises
std::vector<double> Start::run_stage(const std::vector<double>& from, double width,
                                     int evaluations) {
  std::vector<double> stage_best = from;
  Score stage_score{kInfinity, std::vector<double>(limits().size(), -1e300)};
  // Numbers of very different size make steps that are much too long or short.
  double scale = 0;
  BoxProblem box;
  box.limits = limits().size();
  box.evaluate = [&](std::span<const double> x, double* g, double* slope,
                     double* g_slopes) {
    EvaluationRecord record;
    if (plan_.traits.slopes)
      record = soft(x, width);
    else
      record.score = hard(x);
    const Score& score = record.score;
    if (better(score, stage_score, limits())) {
      stage_best.assign(x.begin(), x.end());
      stage_score = score;
    }
    if (!plan_.traits.slopes) take(x, score);
    if (scale == 0 && std::isfinite(score.objective))
      scale = std::max(std::abs(score.objective), 1e-300);
    const std::size_t n = x.size();
    for (std::size_t v = 0; slope && v < n; ++v) slope[v] = record.slope[v] / scale;
    for (std::size_t i = 0; i < box.limits; ++i) {
      const double unit = limits()[i].scale;
      g[i] = std::min(kLimitRoom - score.slacks[i] / unit, kFar);
      for (std::size_t v = 0; g_slopes && v < n; ++v)
        g_slopes[i * n + v] = -record.slopes[i * n + v] / unit;
    }
    return std::isfinite(score.objective) ? score.objective / scale : kInfinity;
  };
  SolverOptions solver;
  solver.evaluations = evaluations;
  solver.tolerance = plan_.traits.slopes && width > 0 ? 1e-5 : 1e-9;
  solver.seed = options_.seed + static_cast<std::uint64_t>(index_);
  solver.cancel = options_.cancel;
  std::vector<double> x = from;
  const SolverStop stop = minimize(plan_.algorithm, box, solver, x);
  if (stop == SolverStop::budget) spent_ = true;
  return stage_best;
}

}  // namespace delos
