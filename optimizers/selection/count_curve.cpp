#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "delos/optimize/choices.h"
#include "selection/branch_and_bound.h"
#include "selection/question.h"
#include "selection/seeing.h"

namespace delos {

CountCurve count_curve(const Scene& scene, PluginRegistry& plugins,
                       const SelectOptions& options, int from, int to,
                       const std::function<void(const CountPoint&)>& progress) {
  if (from < 1 || to < from)
    throw std::invalid_argument("counts run from 1 up, the smaller one first");
  Scene counted = scene;
  counted.selection.budget.reset();
  counted.selection.count = to;
  Question q = question_of(counted, plugins, options);
  const auto kept = std::count(q.decisions.begin(), q.decisions.end(), Decision::in);
  if (from < kept)
    throw std::invalid_argument(std::to_string(kept) +
                                " candidates are kept; begin with that count");
  const std::unique_ptr<FieldCost> cost = cost_of(q, options.threads);
  const Quantity quantity = quantity_of(q);
  CountCurve curve;
  curve.quantity = quantity.text;
  curve.unit = quantity.unit;
  curve.guess = q.guess;
  using Clock = std::chrono::steady_clock;
  for (int count = from; count <= to; ++count) {
    if (options.cancel && *options.cancel) break;
    const Clock::time_point start = Clock::now();
    BranchOptions branch;
    branch.gap = quantity.cost_gap(options.gap);
    branch.seed = options.seed;
    branch.stop = [&] {
      return (options.cancel && *options.cancel) ||
             std::chrono::duration<double>(Clock::now() - start).count() >
                 options.seconds;
    };
    const ChoiceRules rules = rules_for(q.all, count);
    branch.first = judge_blind_samples(*cost, rules, q.decisions, branch.stop);
    const BranchResult found = branch_and_bound(*cost, rules, q.decisions, branch);
    check_settled(*cost);
    check_judged(found.best);
    CountPoint point{count,
                     {},
                     quantity.of(found.best.cost),
                     quantity.of(found.bound),
                     cost->blind_samples(found.best.chosen).size()};
    for (std::size_t i = 0; i < cost->size(); ++i)
      if (found.best.chosen[i]) point.chosen.push_back(i);
    if (progress) progress(point);
    curve.points.push_back(std::move(point));
  }
  curve.all = std::move(q.all);
  return curve;
}

}  // namespace delos
