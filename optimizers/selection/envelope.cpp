#include <algorithm>
#include <cmath>

#include "delos/optimize/choices.h"
#include "selection/branch_and_bound.h"
#include "selection/question.h"
#include "selection/seeing.h"

namespace delos {
namespace {

/// The question about one sample alone, in the first term.
Question at_sample(const Question& q, std::size_t sample) {
  Question one = q;
  one.samples.samples.points = {q.samples.samples.points[sample]};
  one.samples.samples.parts = {{"", 0, 1, ScatteredShape{}}};
  one.samples.set = {0};
  one.samples.multiplicity = {1};
  one.terms.resize(1);
  one.terms[0].weight = 1;
  one.terms[0].maximum = false;
  one.terms[0].samples = {1};
  return one;
}

}  // namespace

Field selection_envelope(const Scene& scene, PluginRegistry& plugins,
                         const SelectOptions& options) {
  const Question q = question_of(scene, plugins, options);
  Field field;
  field.scene = scene.name;
  field.metric = q.terms.front().metric.name;
  field.unit = q.terms.front().metric.unit;
  field.larger_is_better = q.terms.front().metric.larger_is_better;
  field.definition = {q.system.fusion, q.system.covariance};
  field.samples = make_samples(scene.samples);
  const std::size_t count = field.samples.points.size();
  field.value.assign(count, std::numeric_limits<double>::infinity());
  field.observable.assign(count, 1);
  field.lost.assign(count, 0);
  Question every = q;
  every.samples.samples = field.samples;
  for (std::size_t s = 0; s < count; ++s) {
    if (options.cancel && *options.cancel) {
      field.cancelled = true;
      break;
    }
    const Question one = at_sample(every, s);
    const std::unique_ptr<FieldCost> cost = cost_of(one, 1);
    const Quantity quantity = quantity_of(one);
    BranchOptions branch;
    branch.gap = quantity.cost_gap(options.gap);
    branch.seed = options.seed;
    branch.tries = 1;
    branch.stop = [&] { return options.cancel && *options.cancel; };
    branch.first = judge_blind_samples(*cost, q.rules, q.decisions, branch.stop);
    const BranchResult found = branch_and_bound(*cost, q.rules, q.decisions, branch);
    check_settled(*cost);
    if (cost->blind_samples(found.best.chosen).empty())
      field.value[s] = quantity.of(found.bound);
    else
      field.observable[s] = 0;
    field.evaluated = s + 1;
    if (options.progress) options.progress({0, field.value[s], s + 1});
  }
  field.evaluations = field.evaluated;
  return field;
}

}  // namespace delos
