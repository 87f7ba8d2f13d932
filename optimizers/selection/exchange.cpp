#include "selection/exchange.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace delos {
namespace {

/// One candidate in, another out; size(): none.
struct Exchange {
  std::size_t in, out;
  double promise;  ///< the most by which the cost may fall, < 0
};

std::vector<Exchange> promising(const ChoiceRules& rules,
                                const std::vector<Decision>& decisions,
                                const std::vector<char>& chosen,
                                std::span<const double> slope) {
  const std::size_t n = rules.size();
  std::vector<Exchange> all;
  std::vector<std::size_t> outs = {n};
  double spent = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!chosen[i]) continue;
    spent += rules.cost[i];
    if (decisions[i] == Decision::open) outs.push_back(i);
  }
  const double budget = rules.budget * (1 + 1e-12);
  for (std::size_t in = 0; in < n; ++in) {
    if (chosen[in] || decisions[in] != Decision::open) continue;
    std::size_t neighbour = n;  // the one that shares its spot
    for (std::size_t i = 0; i < n && rules.spot[in] >= 0; ++i)
      if (chosen[i] && rules.spot[i] == rules.spot[in]) neighbour = i;
    for (const std::size_t out : outs) {
      if (neighbour < n && out != neighbour) continue;
      const double freed = out < n ? rules.cost[out] : 0;
      if (spent - freed + rules.cost[in] > budget) continue;
      const double promise = slope[in] - (out < n ? slope[out] : 0);
      if (promise < 0) all.push_back({in, out, promise});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Exchange& a, const Exchange& b) {
    return a.promise < b.promise;
  });
  return all;
}

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
  const std::size_t n = rules.size();
  constexpr double kSharp = 1e4;
  std::vector<char> excluded(n);
  for (;;) {
    // At a whole choice candidates that can't be in by a fraction are in or out.
    for (std::size_t i = 0; i < n; ++i) excluded[i] = !choice.chosen[i];
    cost.exclude(excluded);
    Tangent tangent;
    const std::vector<double> w = as_numbers(choice.chosen);
    const bool known = cost.tangent(w, kSharp, tangent);
    if (!known) tangent.slope.assign(n, -1.0);
    // Slopes say nothing of those: they are tried first.
    for (const std::size_t i : cost.whole_ones())
      if (!choice.chosen[i]) tangent.slope[i] = -std::numeric_limits<double>::max();
    bool better = false;
    for (const Exchange& e :
         promising(rules, decisions, choice.chosen, tangent.slope)) {
      if (stop && stop()) return;
      Choice trial = choice;
      trial.chosen[e.in] = 1;
      if (e.out < n) trial.chosen[e.out] = 0;
      trial.cost = cost_of(cost, trial.chosen);
      if (!(trial.cost < choice.cost * (1 - 1e-12))) continue;
      choice = std::move(trial);
      better = true;
      break;
    }
    if (!better) return;
  }
}

}  // namespace delos
