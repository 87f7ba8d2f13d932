#include "selection/seeing.h"

#include <algorithm>

#include "selection/exchange.h"

namespace delos {
namespace {

class SeeingSearch {
 public:
  SeeingSearch(FieldCost& cost, const ChoiceRules& rules,
               const std::function<bool()>& stop)
      : found(rules.size()), cost_(cost), rules_(rules), stop_(stop) {}

  /// @returns whether `found` is one
  bool look(const std::vector<Decision>& decided) {
    if (stop_ && stop_()) return false;
    const ChoicePolytope polytope(rules_, decided);
    if (!polytope.feasible() || asked_ > kMost) return false;
    // The first way to the end is short.
    if (ended_) asked_ += cost_.samples() * (1 + polytope.open().size());
    std::vector<Decision> decisions = polytope.decisions();
    std::vector<char> all(decisions.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = decisions[i] != Decision::out;
      found[i] = decisions[i] == Decision::in;
    }
    if (!is_blind(cost_of(cost_, found))) return true;
    if (is_blind(cost_of(cost_, all))) {
      ended_ = true;
      return false;
    }
    std::vector<Change> changes;
    for (const std::size_t i : polytope.open()) changes.push_back({i, Change::kNobody});
    const std::vector<double> costs = cost_.changed(found, changes);
    const auto best = std::min_element(costs.begin(), costs.end());
    const std::size_t at = changes[static_cast<std::size_t>(best - costs.begin())].in;
    for (const Decision decision : {Decision::in, Decision::out}) {
      decisions[at] = decision;
      if (look(decisions)) return true;
    }
    return false;
  }

  std::vector<char> found;

 private:
  static constexpr std::size_t kMost = 200000;

  FieldCost& cost_;
  const ChoiceRules& rules_;
  const std::function<bool()>& stop_;
  bool ended_ = false;     ///< where nothing was seen
  std::size_t asked_ = 0;  ///< samples of choices since then
};

}  // namespace

std::optional<std::vector<char>> seeing_choice(FieldCost& cost,
                                               const ChoiceRules& rules,
                                               const std::vector<Decision>& decisions,
                                               const std::function<bool()>& stop) {
  SeeingSearch search(cost, rules, stop);
  if (!search.look(decisions)) return std::nullopt;
  return search.found;
}

std::vector<char> judge_blind_samples(FieldCost& cost, const ChoiceRules& rules,
                                      const std::vector<Decision>& decisions,
                                      const std::function<bool()>& stop) {
  std::vector<char> available;
  for (const Decision decision : decisions)
    available.push_back(decision != Decision::out);
  cost.guess_the_always_blind(available);
  if (auto seeing = seeing_choice(cost, rules, decisions, stop)) return *seeing;
  cost.guess_the_blind();
  return {};
}

}  // namespace delos
