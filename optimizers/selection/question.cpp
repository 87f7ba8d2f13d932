#include "selection/question.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "delos/field/evaluate.h"
#include "delos/model/metric_table.h"
#include "delos/scene/definition.h"
#include "delos/text/units.h"
#include "delos/text/words.h"
#include "problem/guess.h"

namespace delos {
namespace {

std::vector<VarianceTerm> variance_terms(const Scene& scene, const System& system,
                                         const SearchSamples& samples) {
  const std::vector<unsigned char> inside =
      samples_inside_solids(system, samples.samples, scene.orientations);
  if (scene.objective.robust != Robustness{})
    throw std::invalid_argument(
        "a selection withstands nothing: objective.robust is for searches; take it "
        "out");
  std::vector<ObjectiveTerm> written = scene.objective.terms;
  if (written.empty()) written.emplace_back();
  std::vector<VarianceTerm> terms;
  for (const ObjectiveTerm& term : written) {
    const auto metric = std::get<Metric>(parse_metric(
        term.metric.empty() ? scene.metric : term.metric, known_metrics(scene)));
    const std::string problem = variance_problem(metric);
    if (!problem.empty()) throw std::invalid_argument(problem);
    if (term.maximize ||
        (term.reduction != Reduction::mean && term.reduction != Reduction::maximum))
      throw std::invalid_argument(
          "a selection minimizes the mean or the maximum over samples, or a weighted "
          "sum of such; other objectives have no bound");
    terms.push_back({metric, term.weight, term.reduction == Reduction::maximum,
                     term_weights(term, scene, samples, inside)});
  }
  return terms;
}

ChoiceRules rules_of(const CandidateScene& all) {
  const Selection& selection = all.scene.selection;
  if (selection.count) return rules_for(all, *selection.count);
  ChoiceRules rules;
  for (const Candidate& c : all.candidates) {
    rules.cost.push_back(c.cost);
    rules.spot.push_back(c.spot);
  }
  rules.budget = *selection.budget;
  return rules;
}

std::vector<Decision> decisions_of(const CandidateScene& all) {
  std::vector<Decision> decisions;
  for (const Candidate& c : all.candidates)
    decisions.push_back(c.kept       ? Decision::in
                        : c.left_out ? Decision::out
                                     : Decision::open);
  return decisions;
}

/// Why no candidate can be chosen.
std::string nothing_to_choose(const Question& q) {
  const auto left_out =
      std::count(q.decisions.begin(), q.decisions.end(), Decision::out);
  if (left_out == static_cast<std::ptrdiff_t>(q.decisions.size()))
    return "selection.leave_out names every candidate, so that none can be chosen";
  const double least = *std::min_element(q.rules.cost.begin(), q.rules.cost.end());
  return "no candidate fits into the budget: the cheapest costs " + shortest(least) +
         ", selection.budget is " + shortest(q.rules.budget);
}

}  // namespace

std::vector<unsigned char> samples_inside_solids(const System& system,
                                                 const Samples& samples,
                                                 const Orientations& orientations) {
  if (system.in_world.triangles() == 0) return {};
  // Where solids are doesn't depend on the devices.
  System one = system;
  one.devices.resize(1);
  const auto coverage = std::get<Metric>(parse_metric("coverage", one.motion.layout));
  return evaluate_field(one, samples, orientations, coverage).inside;
}

Question question_of(const Scene& scene, PluginRegistry& plugins,
                     const SelectOptions& options) {
  if (scene.selection.candidates.empty())
    throw std::invalid_argument(
        "the scene has no selection; say what can be chosen, for example\n"
        "selection:\n  count: 4\n  candidates:\n    - devices: \"*\"");
  if (!scene.selection.count && !scene.selection.budget)
    throw std::invalid_argument("the selection has neither count nor budget");
  Question q;
  auto all = write_out_candidates(with_definition(scene));
  if (const auto* problem = std::get_if<std::string>(&all))
    throw std::invalid_argument(*problem);
  q.all = std::get<0>(std::move(all));
  q.system = build_system(q.all.scene, plugins);
  const std::string problem = adjoint_problem(q.system);
  if (!problem.empty()) throw std::invalid_argument(problem);
  q.samples = search_samples(scene, options.samples);
  q.terms = variance_terms(scene, q.system, q.samples);
  q.guess = scene.objective.guess > 0
                ? scene.objective.guess
                : typical_guess(q.system, q.samples.samples, scene.orientations);
  q.rules = rules_of(q.all);
  q.decisions = decisions_of(q.all);
  const ChoicePolytope polytope(q.rules, q.decisions);
  if (!polytope.feasible())
    throw std::invalid_argument("two candidates that are kept exclude each other");
  const auto is_in = [](Decision d) { return d == Decision::in; };
  if (polytope.open().empty() &&
      std::none_of(q.decisions.begin(), q.decisions.end(), is_in))
    throw std::invalid_argument(nothing_to_choose(q));
  return q;
}

Quantity quantity_of(const Question& q) {
  const std::string over = " over " + std::to_string(q.samples.set.size()) + " samples";
  Quantity quantity;
  std::string sum;
  for (const VarianceTerm& term : q.terms) {
    const bool root = row_of(term.metric.kind).root;
    sum += (sum.empty() ? "" : " + ") +
           (term.weight == 1 ? std::string() : shortest(term.weight) + "·") +
           (term.maximum ? "maximum of " : "mean of ") + term.metric.name +
           (root ? "²" : "");
    if (q.terms.size() > 1) continue;
    quantity.root = root;
    quantity.weight = term.weight;
    quantity.unit = term.metric.unit;
    if (root && term.maximum) sum = "maximum of " + term.metric.name;
    if (root && !term.maximum) sum = "root of the mean of " + term.metric.name + "²";
  }
  quantity.text = sum + over;
  return quantity;
}

ChoiceRules rules_for(const CandidateScene& all, int count) {
  ChoiceRules rules;
  for (const Candidate& c : all.candidates) {
    rules.cost.push_back(1);
    rules.spot.push_back(c.spot);
  }
  rules.budget = count;
  return rules;
}

std::unique_ptr<FieldCost> cost_of(const Question& q, int threads) {
  auto cost = std::make_unique<FieldCost>(
      q.system, q.all, q.samples.samples, q.all.scene.orientations, q.terms,
      guess_information(q.system, q.guess), threads);
  const std::size_t hopeless = cost->hopeless_sample();
  if (hopeless < cost->samples())
    throw std::invalid_argument(
        "at " + coordinates(q.samples.samples.points[hopeless]) +
        " the state isn't observable even if every candidate is chosen");
  return cost;
}

void check_settled(const FieldCost& cost) {
  if (cost.unsettled())
    throw std::invalid_argument(
        "the steady state of some choices didn't settle, so that nothing is proven: "
        "rows with little or no noise may measure states that no noise drives, or "
        "states that drift may hardly be measured");
}

void check_judged(const Choice& best) {
  if (is_blind(best.cost))
    throw std::invalid_argument(
        "no choice that was found observes the state, not even with a guess of the "
        "pose; allow more");
}

}  // namespace delos
