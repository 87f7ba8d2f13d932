#include "selection/exchange.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace delos {
namespace {

/// A change of a choice that the rules allow.
struct Trial {
  Change change;
  double estimate;  ///< of the cost
};

/// All changes that add an open candidate, or exchange one for another, with the cost
/// that adding and removing them one at a time would make together. That is above the
/// cost mostly: a candidate is worth more where another is missing.
class Trials {
 public:
  Trials(ChoiceCost& cost, const ChoiceRules& rules,
         const std::vector<Decision>& decisions, const Choice& choice)
      : rules_(rules), choice_(choice), n_(rules.size()) {
    for (std::size_t i = 0; i < n_; ++i) {
      if (choice.chosen[i]) spent_ += rules.cost[i];
      if (decisions[i] != Decision::open) continue;
      single_.push_back(choice.chosen[i] ? Change{Change::kNobody, i}
                                         : Change{i, Change::kNobody});
    }
    costs_ = cost.changed(choice.chosen, single_);
  }

  [[nodiscard]] std::vector<Trial> sorted() const {
    std::vector<Trial> all;
    for (std::size_t a = 0; a < single_.size(); ++a) {
      const std::size_t in = single_[a].in;
      if (in == Change::kNobody) continue;
      const std::size_t neighbour = at_spot_of(in);
      if (neighbour == Change::kNobody && fits(in, Change::kNobody))
        all.push_back({single_[a], costs_[a]});
      for (std::size_t b = 0; b < single_.size(); ++b) {
        const std::size_t out = single_[b].out;
        if (out == Change::kNobody || !fits(in, out)) continue;
        if (neighbour != Change::kNobody && neighbour != out) continue;
        all.push_back({{in, out}, estimate(costs_[a], costs_[b])});
      }
    }
    std::stable_sort(all.begin(), all.end(), [](const Trial& a, const Trial& b) {
      return a.estimate < b.estimate;
    });
    return all;
  }

 private:
  [[nodiscard]] double estimate(double with_in, double without_out) const {
    if (std::isfinite(choice_.cost) && std::isfinite(without_out))
      return with_in + without_out - choice_.cost;
    return std::min(with_in, without_out);
  }
  [[nodiscard]] bool fits(std::size_t in, std::size_t out) const {
    const double freed = out == Change::kNobody ? 0 : rules_.cost[out];
    return spent_ - freed + rules_.cost[in] <= rules_.budget * (1 + 1e-12);
  }
  /// The chosen one that shares a candidate's spot.
  [[nodiscard]] std::size_t at_spot_of(std::size_t in) const {
    for (std::size_t i = 0; i < n_ && rules_.spot[in] >= 0; ++i)
      if (choice_.chosen[i] && rules_.spot[i] == rules_.spot[in]) return i;
    return Change::kNobody;
  }

  const ChoiceRules& rules_;
  const Choice& choice_;
  std::size_t n_;
  double spent_ = 0;
  std::vector<Change> single_;
  std::vector<double> costs_;
};

std::vector<double> as_numbers(std::span<const char> chosen) {
  return {chosen.begin(), chosen.end()};
}

}  // namespace

std::vector<char> rounded(const ChoiceRules& rules,
                          const std::vector<Decision>& decisions,
                          std::span<const double> preference) {
  const std::size_t n = rules.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return preference[a] > preference[b];
  });
  std::vector<char> chosen(n, 0);
  for (std::size_t i = 0; i < n; ++i) chosen[i] = decisions[i] == Decision::in;
  double spent = 0;
  std::vector<int> taken;
  for (std::size_t i = 0; i < n; ++i) {
    if (!chosen[i]) continue;
    spent += rules.cost[i];
    if (rules.spot[i] >= 0) taken.push_back(rules.spot[i]);
  }
  for (const std::size_t i : order) {
    if (decisions[i] != Decision::open) continue;
    const int spot = rules.spot[i];
    if (spent + rules.cost[i] > rules.budget * (1 + 1e-12)) continue;
    if (spot >= 0 && std::find(taken.begin(), taken.end(), spot) != taken.end())
      continue;
    chosen[i] = 1;
    spent += rules.cost[i];
    if (spot >= 0) taken.push_back(spot);
  }
  return chosen;
}

double cost_of(ChoiceCost& cost, std::span<const char> chosen) {
  return cost.value(as_numbers(chosen));
}

void exchange(ChoiceCost& cost, const ChoiceRules& rules,
              const std::vector<Decision>& decisions, Choice& choice,
              const std::function<bool()>& stop) {
  // So many are tried at a time, the most promising first; then so many in all.
  constexpr std::size_t kBatch = 32, kMost = 256;
  bool better = true;
  while (better && !(stop && stop())) {
    better = false;
    const std::vector<Trial> trials = Trials(cost, rules, decisions, choice).sorted();
    const std::size_t most = std::min(trials.size(), kMost);
    for (std::size_t first = 0; first < most && !better; first += kBatch) {
      if (stop && stop()) return;
      std::vector<Change> batch;
      for (std::size_t i = first; i < std::min(most, first + kBatch); ++i)
        batch.push_back(trials[i].change);
      const std::vector<double> costs = cost.changed(choice.chosen, batch);
      const auto best = std::min_element(costs.begin(), costs.end());
      if (!(*best < choice.cost * (1 - 1e-12))) continue;
      const Change& change = batch[static_cast<std::size_t>(best - costs.begin())];
      choice.chosen[change.in] = 1;
      if (change.out != Change::kNobody) choice.chosen[change.out] = 0;
      choice.cost = *best;
      better = true;
    }
  }
}

}  // namespace delos
