#include <algorithm>

#include "delos/optimize/choices.h"
#include "selection/exchange.h"
#include "selection/question.h"
#include "selection/relaxation.h"

namespace delos {

RemovalOrder removal_order(const Scene& scene, PluginRegistry& plugins,
                           const SelectOptions& options) {
  Question q = question_of(scene, plugins, options);
  const std::unique_ptr<FieldCost> cost = cost_of(q, options.threads);
  const Quantity quantity = quantity_of(q);
  const auto stopped = [&] { return options.cancel && *options.cancel; };
  RemovalOrder order;
  order.quantity = quantity.text;
  order.unit = quantity.unit;
  std::vector<char> chosen;
  for (const Decision decision : q.decisions)
    chosen.push_back(decision != Decision::out);
  order.guess = q.guess;
  const std::vector<char> available = chosen;
  cost->guess_the_always_blind(available);
  order.all_chosen = quantity.of(cost_of(*cost, chosen));
  std::vector<double> w(chosen.begin(), chosen.end());
  while (!q.rules.allow(chosen) && !stopped()) {
    std::vector<Change> changes;
    for (std::size_t i = 0; i < chosen.size(); ++i)
      if (chosen[i] && q.decisions[i] != Decision::in)
        changes.push_back({Change::kNobody, i});
    if (changes.empty()) break;
    cost->guess_the_always_blind(available);
    const std::vector<double> costs = cost->changed(chosen, changes);
    const auto least = std::min_element(costs.begin(), costs.end());
    const std::size_t out =
        changes[static_cast<std::size_t>(least - costs.begin())].out;
    chosen[out] = 0;
    double value = *least;
    if (is_blind(value)) {
      cost->guess_the_blind();
      value = cost_of(*cost, chosen);
    }

    const auto left = static_cast<int>(std::count(chosen.begin(), chosen.end(), 1));
    const ChoiceRules rules = rules_for(q.all, left);
    const ChoicePolytope polytope(rules, q.decisions);
    std::vector<char> excluded(chosen.size());
    for (std::size_t i = 0; i < chosen.size(); ++i)
      excluded[i] = polytope.decisions()[i] == Decision::out;
    cost->exclude(excluded);
    RelaxationOptions relaxation;
    relaxation.steps = 60;
    relaxation.tolerance = 2e-3;
    relaxation.stop = stopped;
    const Relaxation bound = relax(*cost, polytope, w, relaxation);
    w = bound.w;
    order.removals.push_back({out, left, quantity.of(value),
                              quantity.of(std::min(bound.bound, value)),
                              cost->blind_samples(chosen).size()});
    if (options.progress)
      options.progress({order.removals.back().value, order.removals.back().lower_bound,
                        order.removals.size()});
  }
  check_settled(*cost);
  order.all = std::move(q.all);
  return order;
}

}  // namespace delos
