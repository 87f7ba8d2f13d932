#include "delos/optimize/optimize.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <functional>
#include <memory>
#include <numeric>
#include <random>
#include <stdexcept>

#include "crew/crew_search.h"
#include "delos/model/infinity.h"
#include "delos/parallel/jobs.h"
#include "delos/scene/definition.h"
#include "delos/text/words.h"
#include "nlopt/solver.h"
#include "search/feasible.h"
#include "search/start.h"

namespace delos {
namespace {

/// Evaluations of a stage with slopes, where nobody says.
constexpr int kStageEvaluations = 60;
/// Beyond so many variables CCSA found better camera rooms than SLSQP (bench_optimize),
/// whose steps cost n³.
constexpr std::size_t kManyVariables = 30;

/// Whether a single sample can spoil a design, so that most starts end in vain.
bool worst_decides(const Scene& scene) {
  const auto& terms = scene.objective.terms;
  return std::any_of(terms.begin(), terms.end(),
                     [](const ObjectiveTerm& term) {
                       return term.reduction == Reduction::maximum ||
                              term.reduction == Reduction::soft_max;
                     }) ||
         std::any_of(scene.constraints.begin(), scene.constraints.end(),
                     [](const ConstraintEntry& constraint) {
                       return std::holds_alternative<KeepMetric>(constraint.what);
                     });
}

Plan plan_of(const OptimizeOptions& options, Problem& problem) {
  Plan plan;
  const std::size_t n = problem.design().size();
  const bool slopes = problem.slope_problem().empty();
  plan.algorithm = options.algorithm;
  if (options.algorithm == "auto") {
    plan.algorithm = slopes ? (n > kManyVariables ? "ccsa" : "slsqp")
                     : !problem.limits().empty() || n < 2 ? "cobyla"
                                                          : "bobyqa";
  }
  const auto names = solver_names();
  if (std::find(names.begin(), names.end(), plan.algorithm) == names.end())
    throw std::invalid_argument("there is no algorithm '" + plan.algorithm + "'");
  plan.traits = solver_traits(plan.algorithm);
  if (plan.traits.slopes && !slopes)
    throw std::invalid_argument(plan.algorithm + " needs derivatives, but " +
                                problem.slope_problem() +
                                "; use cobyla, bobyqa, crs2 or isres");
  if (plan.algorithm == "bobyqa" && n < 2)
    throw std::invalid_argument("bobyqa needs two variables or more; use cobyla");
  plan.starts = options.starts > 0                        ? options.starts
                : plan.traits.global                      ? 1
                : worst_decides(problem.design().scene()) ? 16
                                                          : 4;
  const int whole = static_cast<int>(std::size(kWidths)) * kStageEvaluations;
  const int by_size = 50 * static_cast<int>(n) + 200;
  plan.per_start = options.evaluations > 0
                       ? std::max(options.evaluations / plan.starts, 4)
                   : plan.traits.global ? 4 * by_size
                   : plan.traits.slopes ? whole
                                        : by_size;
  return plan;
}

/// The scene as it stands, then random points: half of them near it.
std::vector<double> start_of(const std::vector<double>& given, int index,
                             std::uint64_t seed) {
  if (index == 0) return given;
  std::seed_seq sequence{static_cast<std::uint32_t>(seed),
                         static_cast<std::uint32_t>(seed >> 32),
                         static_cast<std::uint32_t>(index)};
  std::mt19937_64 random(sequence);
  // Not std::uniform_real_distribution, whose numbers differ between libraries.
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<double> x = given;
  for (double& value : x)
    value =
        index % 2 == 1 ? std::clamp(value + 0.3 * (unit() - 0.5), 0.0, 1.0) : unit();
  return x;
}

/// Starts that are worked on by several threads, each at a workplace of its own.
class Team {
 public:
  Team(const Scene& scene, PluginRegistry& plugins, const OptimizeOptions& options,
       std::size_t starts) {
    const std::size_t threads = worker_count(options.threads);
    const std::size_t workers = std::min(threads, starts);
    const auto each = static_cast<int>(threads / workers);
    for (std::size_t w = 0; w < workers; ++w)
      places_.push_back(std::make_unique<Workplace>(
          scene, plugins, ProblemOptions{options.samples, each}));
  }

  /// work(k, place) for every k < count.
  template <class Work>
  void each(std::size_t count, Work&& work) {
    each_job(count, places_.size(),
             [&](std::size_t k, std::size_t w) { work(k, *places_[w]); });
  }

  [[nodiscard]] const std::vector<Limit>& limits() const {
    return places_[0]->problem.limits();
  }

 private:
  std::vector<std::unique_ptr<Workplace>> places_;
};

/// Work on the starts of this part, and then, where parts meet, on those of the others,
/// whose evaluations are recalled.
/// @param which indices of starts, in the order in which they are divided
template <class Work>
void each_part(Team& team, const std::vector<std::size_t>& which,
               const OptimizeOptions& options, Work&& work) {
  std::vector<std::size_t> mine, others;
  for (std::size_t k = 0; k < which.size(); ++k)
    (k % options.parts.of == options.parts.index ? mine : others).push_back(which[k]);
  std::string problem;
  try {
    team.each(mine.size(), [&](std::size_t k, Workplace& at) { work(mine[k], at); });
  } catch (const std::exception& failure) {
    if (!options.meet) throw;
    problem = failure.what();
  }
  if (!options.meet) return;
  options.meet(problem);
  team.each(others.size(), [&](std::size_t k, Workplace& at) { work(others[k], at); });
}

/// Explore from all starts, and finish the better half, the best first. A part that
/// doesn't meet the others can't know which those are, and finishes all of its own.
/// @returns all; those of parts that aren't searched here aren't explored
std::vector<Start> run_starts(const Scene& scene, PluginRegistry& plugins,
                              const OptimizeOptions& options, const Plan& plan,
                              const std::vector<std::vector<double>>& from,
                              Shared& shared) {
  std::vector<Start> starts;
  for (std::size_t k = 0; k < from.size(); ++k)
    starts.emplace_back(options, plan, static_cast<int>(k), shared);
  Team team(scene, plugins, options, from.size());
  std::vector<std::size_t> order(from.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  each_part(team, order, options,
            [&](std::size_t k, Workplace& at) { starts[k].explore(at, from[k]); });
  const bool alone = options.parts.of > 1 && !options.meet;
  if (!alone) {
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      if (!starts[a].explored() || !starts[b].explored())
        return starts[a].explored() && !starts[b].explored();
      return better(starts[a].best_score(), starts[b].best_score(), team.limits());
    });
    order.resize((from.size() + 1) / 2);
  }
  each_part(team, order, options,
            [&](std::size_t k, Workplace& at) { starts[k].finish(at); });
  return starts;
}

}  // namespace

const char* to_string(SearchStop stop) {
  switch (stop) {
    case SearchStop::converged:
      return "converged";
    case SearchStop::budget:
      return "budget";
    case SearchStop::cancelled:
      return "cancelled";
    case SearchStop::infeasible:
      return "infeasible";
  }
  return "";
}

std::vector<std::string> algorithm_names() {
  std::vector<std::string> names = solver_names();
  names.insert(names.begin(), "auto");
  return names;
}

std::vector<ConstraintReport> constraint_reports(Problem& problem, const Score& score) {
  std::vector<ConstraintReport> all;
  for (const ConstraintEntry& entry : problem.design().scene().constraints)
    all.push_back({entry.name, true, kInfinity});
  for (std::size_t i = 0; i < problem.limits().size(); ++i) {
    ConstraintReport& one = all[problem.limits()[i].constraint];
    one.slack = std::min(one.slack, score.slacks[i]);
    one.satisfied = one.slack >= 0;
  }
  return all;
}

Scene with_guess(Scene scene, PluginRegistry& plugins) {
  if (scene.objective.guess == 0)
    scene.objective.guess = Problem(scene, plugins, {0, 0}).guess();
  return with_definition(std::move(scene));
}

OptimizeResult optimize(const Scene& given, PluginRegistry& plugins,
                        const OptimizeOptions& options) {
  if (options.crew) return search_with_crew(given, plugins, options);
  const auto begin = std::chrono::steady_clock::now();
  const Scene scene = with_guess(given, plugins);
  Problem whole(scene, plugins, {0, options.threads});
  const Plan plan = plan_of(options, whole);
  OptimizeResult result;
  result.algorithm = plan.algorithm;
  result.initial_scene = scene;
  result.messages = whole.design().repairs();

  std::vector<std::vector<double>> starts;
  const auto stopped = [&] { return options.cancel && options.cancel->load(); };
  for (int k = 0; k < plan.starts && (k == 0 || !stopped()); ++k) {
    const Repair repaired =
        repair(whole, start_of(whole.design().start(), k, options.seed));
    if (k == 0 && !repaired.feasible)
      throw std::invalid_argument(
          "no design keeps all of: " + joined(repaired.violated) +
          "; at least one of them must give way");
    if (k == 0 && repaired.moved)
      result.messages.push_back("the scene as it stands doesn't keep " +
                                joined(repaired.violated) +
                                "; the search starts at the nearest design that does");
    if (repaired.feasible) starts.push_back(repaired.x);
  }

  Shared shared(options, static_cast<std::size_t>(plan.per_start) * starts.size());
  const std::vector<Start> ends =
      run_starts(scene, plugins, options, plan, starts, shared);

  // Judge all ends on all samples, and never leave with less than there was.
  result.initial_x = whole.design().start();
  result.initial = whole.score(result.initial_x);
  result.best_x = starts.front();
  result.best = whole.score(result.best_x);
  for (const Start& end : ends) {
    if (!end.explored()) continue;
    const Score score = whole.score(end.best());
    if (!better(score, result.best, whole.limits())) continue;
    result.best = score;
    result.best_x = end.best();
  }
  if (better(result.initial, result.best, whole.limits())) {
    result.best = result.initial;
    result.best_x = result.initial_x;
  }
  result.constraints = constraint_reports(whole, result.best);
  result.plain_initial = whole.plain_objective(result.initial_x);
  result.plain_best = whole.plain_objective(result.best_x);
  result.initial_field = whole.field(result.initial_x);
  result.best_field = whole.field(result.best_x);
  result.scene = whole.design().scene();
  const bool spent = std::any_of(ends.begin(), ends.end(),
                                 [](const Start& end) { return end.spent(); });
  result.stop = !result.best.feasible() ? SearchStop::infeasible
                : stopped()             ? SearchStop::cancelled
                : spent                 ? SearchStop::budget
                                        : SearchStop::converged;
  result.evaluations = shared.evaluations();
  result.gradient_evaluations = shared.gradient_evaluations();
  result.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace delos
