#include "selection/cover_search.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <utility>

namespace delos {

CoverSearch::CoverSearch(const CoverCore& core, std::uint64_t seed)
    : core_(core),
      nobody_(core.candidates()),
      several_(core.candidates() + 1),
      random_(seed),
      count_(core.samples(), 0),
      holders_(core.samples()),
      sole_(core.samples(), nobody_),
      weight_(core.samples(), 1),
      score_(core.candidates(), 0),
      spared_(core.candidates() + 2, 0),
      moved_(core.candidates(), -2),
      place_(core.candidates(), -1),
      missed_(core.samples()),
      missed_place_(core.samples()) {
  int groups = 0;
  for (const int g : core.group) groups = std::max(groups, g + 1);
  member_.assign(groups, -1);
  std::iota(missed_.begin(), missed_.end(), 0);
  missed_place_ = missed_;
  for (const double cost : core.cost) per_cost_.push_back(1 / cost);
  for (int j = 0; j < core.candidates(); ++j)
    score_[j] = static_cast<std::int64_t>(core.seen[j].size());
  greedy();
}

void CoverSearch::now_missed(int i) {
  missed_place_[i] = static_cast<int>(missed_.size());
  missed_.push_back(i);
}

void CoverSearch::no_longer_missed(int i) {
  const int last = missed_.back();
  missed_[missed_place_[i]] = last;
  missed_place_[last] = missed_place_[i];
  missed_place_[i] = -1;
  missed_.pop_back();
}

/// Note who keeps the demand of a sample whose count has changed.
/// @returns how many more than its demand see it
int CoverSearch::recount(int i) {
  const auto& holders = holders_[i];
  const int over = count_[i] - core_.demand[i];
  sole_[i] = over != 0 ? nobody_ : holders.size() == 1 ? holders.front() : several_;
  // The scores of all its seers change where a demand is just met, or just over.
  if (over >= -1 && over <= 1)
    work_ += static_cast<std::int64_t>(core_.seers[i].size());
  return over;
}

void CoverSearch::select(int j) {
  place_[j] = static_cast<int>(selected_.size());
  selected_.push_back(j);
  cost_ += core_.cost[j];
  if (core_.group[j] >= 0) member_[core_.group[j]] = j;
  score_[j] = 0;
  for (const int i : core_.seen[j]) {
    holders_[i].push_back(j);
    ++count_[i];
    const int over = recount(i);
    if (over <= 0) score_[j] += weight_[i];
    if (over == 0) {  // others gain nothing there any more
      no_longer_missed(i);
      for (const int k : core_.seers[i])
        if (place_[k] < 0) score_[k] -= weight_[i];
    } else if (over == 1) {  // nor would the loss of one be one
      for (const int k : core_.seers[i])
        if (place_[k] >= 0 && k != j) score_[k] -= weight_[i];
    }
  }
  work_ += static_cast<std::int64_t>(core_.seen[j].size());
}

void CoverSearch::deselect(int j) {
  const int last = selected_.back();
  selected_[place_[j]] = last;
  place_[last] = place_[j];
  place_[j] = -1;
  selected_.pop_back();
  cost_ -= core_.cost[j];
  if (core_.group[j] >= 0) member_[core_.group[j]] = -1;
  score_[j] = 0;
  for (const int i : core_.seen[j]) {
    auto& holders = holders_[i];
    *std::find(holders.begin(), holders.end(), j) = holders.back();
    holders.pop_back();
    --count_[i];
    const int over = recount(i);
    if (over < 0) score_[j] += weight_[i];
    if (over == 0) {
      for (const int k : core_.seers[i])
        if (place_[k] >= 0) score_[k] += weight_[i];
    } else if (over == -1) {
      now_missed(i);
      for (const int k : core_.seers[i])
        if (place_[k] < 0 && k != j) score_[k] += weight_[i];
    }
  }
  work_ += static_cast<std::int64_t>(core_.seen[j].size());
}

/// Select j in place of its group's member.
void CoverSearch::put(int j) {
  const int g = core_.group[j];
  if (g >= 0 && member_[g] >= 0) take(member_[g]);
  select(j);
  moved_[j] = moves_;
}

/// Deselect j, and not for this step alone.
void CoverSearch::take(int j) {
  deselect(j);
  moved_[j] = moves_;
}

/// What selecting j gains for its cost, less what the group's member leaves.
double CoverSearch::value(int j) const {
  const int g = core_.group[j];
  const std::int64_t left = g >= 0 && member_[g] >= 0 ? score_[member_[g]] : 0;
  return static_cast<double>(score_[j] - left) * per_cost_[j];
}

int CoverSearch::least_loss() const {
  int least = selected_.front();
  double loss = kNone;
  for (const int j : selected_) {
    const double own = static_cast<double>(score_[j]) * per_cost_[j];
    if (own > loss || (own == loss && moved_[j] >= moved_[least])) continue;
    least = j;
    loss = own;
  }
  return least;
}

int CoverSearch::most_gain(int sample, double limit) const {
  int most = -1;
  double gain = -kNone;
  for (const int j : core_.seers[sample]) {
    if (place_[j] >= 0 || moved_[j] >= moves_ - 1) continue;
    const int g = core_.group[j];
    const double saved = g >= 0 && member_[g] >= 0 ? core_.cost[member_[g]] : 0;
    if (!(cost_ - saved + core_.cost[j] < limit)) continue;
    const double own = value(j);
    if (own > gain || (own == gain && moved_[j] < moved_[most])) {
      most = j;
      gain = own;
    }
  }
  return most;
}

void CoverSearch::greedy() {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry> queue;
  for (int j = 0; j < core_.candidates(); ++j) queue.push({value(j), -j});
  while (!missed_.empty() && !queue.empty()) {
    const auto [gain, negative] = queue.top();
    const int j = -negative;
    queue.pop();
    if (core_.group[j] >= 0 && member_[core_.group[j]] >= 0) continue;
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
void CoverSearch::clean() {
  for (;;) {
    int dearest = -1;
    for (const int j : selected_)
      if (score_[j] == 0 && (dearest < 0 || core_.cost[j] > core_.cost[dearest] ||
                             (core_.cost[j] == core_.cost[dearest] && j > dearest)))
        dearest = j;
    if (dearest < 0) return;
    deselect(dearest);
  }
}

void CoverSearch::note_cover() {
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

/// The selected candidate whose loss is least once j is selected: what j sees too,
/// others need no longer. Of j's group: its member.
CoverSearch::Exchange CoverSearch::exchange_for(int j) {
  for (const int i : core_.seen[j]) {
    spared_[sole_[i]] += weight_[i];
    if (sole_[i] != several_) continue;
    for (const int k : holders_[i]) spared_[k] += weight_[i];
  }
  work_ += static_cast<std::int64_t>(core_.seen[j].size() + selected_.size());
  const int taken = core_.group[j] < 0 ? -1 : member_[core_.group[j]];
  Exchange exchange{j};
  double least = kNone;
  for (const int k : selected_) {
    const double loss = static_cast<double>(score_[k] - spared_[k]) * per_cost_[k];
    spared_[k] = 0;
    const bool may_go = taken >= 0 ? k == taken : moved_[k] < moves_ - 1;
    if (!may_go || !(loss < least)) continue;
    exchange.out = k;
    least = loss;
  }
  exchange.value = static_cast<double>(score_[j]) * per_cost_[j] - least;
  return exchange;
}

/// The exchange of most value for a candidate that sees the sample.
CoverSearch::Exchange CoverSearch::best_exchange(int sample) {
  Exchange best;
  for (const int j : core_.seers[sample]) {
    if (place_[j] >= 0 || moved_[j] >= moves_ - 1) continue;
    const Exchange own = exchange_for(j);
    if (own.out >= 0 && (best.in < 0 || own.value > best.value ||
                         (own.value == best.value && moved_[j] < moved_[best.in])))
      best = own;
  }
  return best;
}

void CoverSearch::step(double limit) {
  ++moves_;
  const int sample = missed_[random_() % missed_.size()];
  work_ += static_cast<std::int64_t>(core_.seers[sample].size());
  Exchange exchange{most_gain(sample, limit)};
  if (exchange.in >= 0)
    exchange.value = value(exchange.in);
  else
    exchange = best_exchange(sample);
  if (exchange.out >= 0) take(exchange.out);
  if (exchange.in >= 0) put(exchange.in);
  if (exchange.value > 0) return;
  for (const int i : missed_) {
    ++weight_[i];
    work_ += static_cast<std::int64_t>(core_.seers[i].size());
    for (const int k : core_.seers[i]) ++score_[k];
  }
}

void CoverSearch::run(std::int64_t work, double limit, double enough) {
  const std::int64_t end = work_ + work;
  while (work_ < end && best_cost_ > enough) {
    limit = std::min(limit, best_cost_);
    while (!selected_.empty() && !(cost_ < limit)) {
      ++moves_;
      take(least_loss());
    }
    if (!missed_.empty()) step(limit);
    if (!missed_.empty()) continue;
    note_cover();
    ++work_;
  }
}

}  // namespace delos
