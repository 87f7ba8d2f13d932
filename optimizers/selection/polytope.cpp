#include "selection/polytope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace delos {
namespace {

/// Costs add up to a budget but for rounding.
double with_rounding(double budget) { return budget * (1 + 1e-12); }

/// The nearest point with w ≥ 0 and Σ w ≤ 1; coordinates then are at most 1.
/// Source: Held, Wolfe, Crowder (1974), Math. Prog. 6, 62–88 (projection by sorting).
void project_simplex(std::span<double> w) {
  double sum = 0;
  for (const double x : w) sum += std::max(x, 0.0);
  double shift = 0;
  if (sum > 1) {
    std::vector<double> sorted(w.begin(), w.end());
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    double head = 0;
    for (std::size_t k = 0; k < sorted.size(); ++k) {
      head += sorted[k];
      const double t = (head - 1) / static_cast<double>(k + 1);
      if (t >= sorted[k]) break;
      shift = t;
    }
  }
  for (double& x : w) x = std::max(x - shift, 0.0);
}

}  // namespace

bool ChoiceRules::allow(std::span<const char> chosen) const {
  double sum = 0;
  std::vector<int> taken;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!chosen[i]) continue;
    sum += cost[i];
    if (spot[i] >= 0) taken.push_back(spot[i]);
  }
  std::sort(taken.begin(), taken.end());
  return sum <= with_rounding(budget) &&
         std::adjacent_find(taken.begin(), taken.end()) == taken.end();
}

ChoicePolytope::ChoicePolytope(const ChoiceRules& rules,
                               std::vector<Decision> decisions)
    : rules_(rules), decisions_(std::move(decisions)), left_(rules.budget) {
  std::map<int, int> taken;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (decisions_[i] != Decision::in) continue;
    left_ -= rules.cost[i];
    if (rules.spot[i] >= 0 && ++taken[rules.spot[i]] > 1) feasible_ = false;
  }
  if (with_rounding(rules.budget) - rules.budget + left_ < 0) feasible_ = false;
  left_ = std::max(left_, 0.0);
  std::map<int, std::vector<std::size_t>> by_spot;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (decisions_[i] != Decision::open) continue;
    const int spot = rules.spot[i];
    if (rules.cost[i] > left_ + 1e-12 * rules.budget || taken.count(spot) > 0) {
      decisions_[i] = Decision::out;
      continue;
    }
    open_.push_back(i);
    if (spot >= 0)
      by_spot[spot].push_back(i);
    else
      spots_.push_back({i});
  }
  for (auto& [spot, members] : by_spot) spots_.push_back(std::move(members));
}

void ChoicePolytope::project_spots(std::span<double> w) const {
  std::vector<double> part;
  for (const auto& members : spots_) {
    if (members.size() == 1) {
      w[members[0]] = std::clamp(w[members[0]], 0.0, 1.0);
      continue;
    }
    part.clear();
    for (const std::size_t i : members) part.push_back(w[i]);
    project_simplex(part);
    for (std::size_t k = 0; k < members.size(); ++k) w[members[k]] = part[k];
  }
}

void ChoicePolytope::project(std::span<double> w) const {
  for (std::size_t i = 0; i < decisions_.size(); ++i)
    if (decisions_[i] != Decision::open) w[i] = decisions_[i] == Decision::in ? 1 : 0;
  const std::vector<double> z(w.begin(), w.end());
  const auto spent = [&](double multiplier) {
    for (const std::size_t i : open_) w[i] = z[i] - multiplier * rules_.cost[i];
    project_spots(w);
    double sum = 0;
    for (const std::size_t i : open_) sum += rules_.cost[i] * w[i];
    return sum;
  };
  if (spent(0) <= left_) return;
  // Σ c w falls with the multiplier; at the upper end nothing is left.
  double low = 0, high = 0;
  for (const std::size_t i : open_) high = std::max(high, z[i] / rules_.cost[i]);
  constexpr int kHalvings = 60;
  for (int k = 0; k < kHalvings && high - low > 1e-15 * high; ++k) {
    const double middle = (low + high) / 2;
    (spent(middle) > left_ ? low : high) = middle;
  }
  spent(high);
}

ChoicePolytope::LinearBound ChoicePolytope::linear_bound(
    std::span<const double> g) const {
  // Where money is short a candidate is worth −g/c of it; the bound is concave in μ,
  // and what would be bought falls with μ.
  const auto bought = [&](double multiplier) {
    double sum = 0;
    for (const auto& members : spots_) {
      double least = 0, cost = 0;
      for (const std::size_t i : members) {
        const double reduced = g[i] + multiplier * rules_.cost[i];
        if (reduced < least) {
          least = reduced;
          cost = rules_.cost[i];
        }
      }
      sum += cost;
    }
    return sum;
  };
  double low = 0, high = 0;
  for (const std::size_t i : open_) high = std::max(high, -g[i] / rules_.cost[i]);
  if (bought(0) <= left_) high = 0;
  constexpr int kHalvings = 60;
  for (int k = 0; k < kHalvings && high - low > 1e-15 * high; ++k) {
    const double middle = (low + high) / 2;
    (bought(middle) > left_ ? low : high) = middle;
  }
  const double mu = high;

  LinearBound bound;
  bound.if_in.assign(rules_.size(), 0.0);
  bound.if_out.assign(rules_.size(), 0.0);
  bound.value = -mu * left_;
  for (std::size_t i = 0; i < decisions_.size(); ++i)
    if (decisions_[i] == Decision::in) bound.value += g[i];
  for (const auto& members : spots_) {
    double least = 0, second = 0;
    std::size_t best = members.size();
    for (std::size_t k = 0; k < members.size(); ++k) {
      const double reduced = g[members[k]] + mu * rules_.cost[members[k]];
      if (reduced < least) {
        second = least;
        least = reduced;
        best = k;
      } else {
        second = std::min(second, reduced);
      }
    }
    bound.value += least;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const std::size_t i = members[k];
      bound.if_in[i] = g[i] + mu * rules_.cost[i] - least;
      if (k == best) bound.if_out[i] = second - least;
    }
  }
  return bound;
}

}  // namespace delos
