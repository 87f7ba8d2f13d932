#include "cover/cover_selection.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <utility>

namespace delos {

CoverSelection::CoverSelection(const CoverCore& core)
    : core_(core),
      several_(core.candidates()),
      count_(core.samples(), 0),
      holders_(core.samples()),
      sole_(core.samples()),
      weight_(core.samples(), 1),
      gain_(core.candidates(), 0),
      loss_(nobody(kNobodies - 1) + 1, 0),
      per_cost_(loss_.size(), 0),
      open_loss_(loss_.size(), kNone),
      left_(loss_.size(), kNone),
      moved_(core.candidates(), std::numeric_limits<int>::min()),
      place_(core.candidates(), -1),
      missed_(core.samples()),
      missed_place_(core.samples()) {
  int groups = 0;
  for (const int g : core.group) groups = std::max(groups, g + 1);
  member_.assign(groups, -1);
  std::iota(missed_.begin(), missed_.end(), 0);
  missed_place_ = missed_;
  for (int i = 0; i < core.samples(); ++i) sole_[i] = nobody(i);
  for (int j = 0; j < core.candidates(); ++j) {
    per_cost_[j] = 1 / core.cost[j];
    gain_[j] = static_cast<double>(core.seen[j].size());
  }
  greedy();
}

void CoverSelection::now_missed(int i) {
  missed_place_[i] = static_cast<int>(missed_.size());
  missed_.push_back(i);
}

void CoverSelection::no_longer_missed(int i) {
  const int last = missed_.back();
  missed_[missed_place_[i]] = last;
  missed_place_[last] = missed_place_[i];
  missed_place_[i] = -1;
  missed_.pop_back();
}

/// Note who keeps the demand of a sample whose count has changed.
/// @returns how many more than its demand see it
int CoverSelection::recount(int i) {
  const auto& holders = holders_[i];
  const int over = count_[i] - core_.demand[i];
  sole_[i] = over != 0 ? nobody(i) : holders.size() == 1 ? holders.front() : several_;
  return over;
}

void CoverSelection::change_gains(int i, double by) {
  for (const int j : core_.seers[i]) gain_[j] += by;
  work_ += static_cast<std::int64_t>(core_.seers[i].size());
}

void CoverSelection::select(int j) {
  place_[j] = static_cast<int>(selected_.size());
  selected_.push_back(j);
  cost_ += core_.cost[j];
  if (core_.group[j] >= 0) member_[core_.group[j]] = j;
  loss_[j] = 0;
  for (const int i : core_.seen[j]) {
    ++count_[i];
    holders_[i].push_back(j);
    const int over = recount(i);
    if (over <= 0) loss_[j] += weight_[i];
    if (over == 0) {
      no_longer_missed(i);
      change_gains(i, -weight_[i]);
    } else if (over == 1) {
      for (const int k : holders_[i])
        if (k != j) loss_[k] -= weight_[i];
    }
  }
  work_ += static_cast<std::int64_t>(core_.seen[j].size());
}

void CoverSelection::deselect(int j) {
  const int last = selected_.back();
  selected_[place_[j]] = last;
  place_[last] = place_[j];
  place_[j] = -1;
  selected_.pop_back();
  cost_ -= core_.cost[j];
  if (core_.group[j] >= 0) member_[core_.group[j]] = -1;
  for (const int i : core_.seen[j]) {
    auto& holders = holders_[i];
    --count_[i];
    *std::find(holders.begin(), holders.end(), j) = holders.back();
    holders.pop_back();
    const int over = recount(i);
    if (over == 0) {
      for (const int k : holders) loss_[k] += weight_[i];
    } else if (over == -1) {
      now_missed(i);
      change_gains(i, weight_[i]);
    }
  }
  work_ += static_cast<std::int64_t>(core_.seen[j].size());
}

void CoverSelection::put(int j, std::int64_t step) {
  if (const int other = member(j); other >= 0) take(other, step);
  select(j);
  moved_[j] = step;
}

void CoverSelection::take(int k, std::int64_t step) {
  deselect(k);
  moved_[k] = step;
}

double CoverSelection::value(int j) const {
  const int other = member(j);
  return (gain_[j] - (other >= 0 ? loss_[other] : 0)) * per_cost_[j];
}

int CoverSelection::least_loss() const {
  int least = selected_.front();
  for (const int k : selected_)
    if (loss(k) < loss(least) || (loss(k) == loss(least) && moved_[k] < moved_[least]))
      least = k;
  return least;
}

void CoverSelection::weigh_missed() {
  for (const int i : missed_) {
    ++weight_[i];
    change_gains(i, 1);
    for (const int k : holders_[i]) ++loss_[k];
  }
}

void CoverSelection::greedy() {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry> queue;
  for (int j = 0; j < core_.candidates(); ++j) queue.push({value(j), -j});
  while (!missed_.empty() && !queue.empty()) {
    const auto [gain, negative] = queue.top();
    const int j = -negative;
    queue.pop();
    if (member(j) >= 0) continue;
    // Gains only fall: the first that is up to date is the most.
    if (const double own = value(j); own < gain) {
      if (own > 0) queue.push({own, negative});
      continue;
    }
    select(j);
  }
  if (missed_.empty()) note_cover();
}

/// Deselect what isn't needed, the dearest first.
void CoverSelection::clean() {
  for (;;) {
    int dearest = -1;
    for (const int j : selected_)
      if (loss_[j] == 0 && (dearest < 0 || core_.cost[j] > core_.cost[dearest] ||
                            (core_.cost[j] == core_.cost[dearest] && j > dearest)))
        dearest = j;
    if (dearest < 0) return;
    deselect(dearest);
  }
}

void CoverSelection::note_cover() {
  clean();
  // Sums of costs in another order differ by roundings.
  double cost = 0;
  std::vector<int> cover = selected_;
  std::sort(cover.begin(), cover.end());
  for (const int j : cover) cost += core_.cost[j];
  cost_ = cost;
  if (!(cost < best_cost_)) return;
  best_cost_ = cost;
  best_ = cover;
}

void CoverSelection::open_losses(std::int64_t before) {
  least_ = {-1, -1, kNone};
  for (const int k : selected_) {
    open_loss_[k] = left_[k] = moved_[k] < before ? loss(k) : kNone;
    if (open_loss_[k] < least_.value ||
        (open_loss_[k] == least_.value && least_.out >= 0 &&
         moved_[k] < moved_[least_.out]))
      least_ = {-1, k, open_loss_[k]};
  }
  work_ += static_cast<std::int64_t>(selected_.size());
}

CoverSelection::Exchange CoverSelection::exchange_for(int j, double worth) {
  const auto seen = core_.seen[j];
  const int* const sole = sole_.data();
  const double* const weight = weight_.data();
  const double* const per_cost = per_cost_.data();
  const double* const open_loss = open_loss_.data();
  double* const left = left_.data();
  const int several = several_;
  const auto each_keeper = [&](auto&& act) {
    for (const int i : seen) {
      const int k = sole[i];
      if (k != several) {
        act(k, i);
      } else {
        for (const int holder : holders_[i]) act(holder, i);
      }
    }
  };
  const double gain = gain_[j] * per_cost[j];
  Exchange exchange{j, least_.out, least_.value};
  if (const int other = member(j); other >= 0) {
    exchange = {j, other, loss(other)};
    each_keeper([&](int k, int i) {
      if (k == other) exchange.value -= weight[i] * per_cost[k];
    });
  } else {
    // What is left of a loss only falls, so that the least on the way is the last
    // one's.
    double value = least_.value;
    each_keeper([&](int k, int i) {
      left[k] -= weight[i] * per_cost[k];
      value = std::min(value, left[k]);
    });
    exchange.value = value;
    if (value < kNone && gain - value >= worth) {
      if (value < least_.value) exchange.out = -1;
      each_keeper([&](int k, int) {
        if (left[k] == value && (exchange.out < 0 || moved_[k] < moved_[exchange.out]))
          exchange.out = k;
      });
    }
    each_keeper([&](int k, int) { left[k] = open_loss[k]; });
  }
  work_ += static_cast<std::int64_t>(seen.size());
  exchange.value = gain - exchange.value;
  return exchange;
}

}  // namespace delos
