#include "cover/cover_core.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace delos {
namespace {

/// Finds the lists that contain a list. Most others are told apart by which of 512
/// items they have.
class Supersets {
 public:
  Supersets(const Lists& lists, const Lists& owners) : lists_(lists), owners_(owners) {
    signature_.resize(lists.size());
    const int items = owners.size();
    const int bits = std::min(items, 64 * static_cast<int>(kWords));
    // Stride by the golden ratio: items of a grid's row or layer aren't all alike.
    for (int bit = 0; bit < bits; ++bit) {
      const double turn = 0.6180339887498949 * bit;
      const int item =
          bits == items ? bit : static_cast<int>((turn - int(turn)) * items);
      for (const int j : owners[item]) signature_[j][bit / 64] |= 1ull << (bit % 64);
    }
  }

  /// Call visit(b) for each b ≠ a whose list contains a's, until it returns false.
  template <class Visit>
  void each(int a, Visit visit) const {
    const auto list = lists_[a];
    if (list.empty()) return;
    const auto size = [&](int item) { return owners_[item].size(); };
    const int rarest = *std::min_element(
        list.begin(), list.end(), [&](int i, int j) { return size(i) < size(j); });
    for (const int b : owners_[rarest]) {
      if (b == a || lists_[b].size() < list.size() || !maybe(a, b)) continue;
      const auto other = lists_[b];
      if (std::includes(other.begin(), other.end(), list.begin(), list.end()) &&
          !visit(b))
        return;
    }
  }

 private:
  static constexpr std::size_t kWords = 8;

  bool maybe(int a, int b) const {
    for (std::size_t w = 0; w < kWords; ++w)
      if (signature_[a][w] & ~signature_[b][w]) return false;
    return true;
  }

  const Lists &lists_, &owners_;
  std::vector<std::array<std::uint64_t, kWords>> signature_;
};

/// How many may see a sample: each candidate, but only one of a group.
/// @param enough counting ends there
int seers_at_most(const CoverCore& core, int sample, int enough) {
  std::vector<int> groups;
  int count = 0;
  for (const int j : core.seers[sample]) {
    if (count >= enough) break;
    const int g = core.group[j];
    if (g >= 0) {
      if (std::find(groups.begin(), groups.end(), g) != groups.end()) continue;
      groups.push_back(g);
    }
    ++count;
  }
  return count;
}

/// Choose j: its samples demand one less; it and its group are free no more.
void choose(CoverCore& core, int j, std::vector<char>& keep) {
  core.chosen.push_back(core.candidate[j]);
  core.chosen_cost += core.cost[j];
  for (const int i : core.seen[j]) --core.demand[i];
  keep[j] = 0;
  for (int k = 0; core.group[j] >= 0 && k < core.candidates(); ++k)
    if (core.group[k] == core.group[j]) keep[k] = 0;
}

/// Choose what can't be done without.
void force(CoverCore& core, std::vector<char>& keep) {
  std::vector<char> needed(core.candidates(), 0);
  for (int i = 0; i < core.samples(); ++i) {
    if (seers_at_most(core, i, core.demand[i] + 1) != core.demand[i]) continue;
    for (const int j : core.seers[i])
      if (core.group[j] < 0) needed[j] = 1;
  }
  for (int j = 0; j < core.candidates(); ++j)
    if (needed[j]) choose(core, j, keep);
}

/// Samples that others imply, of those that are left.
void drop_samples(const CoverCore& core, std::vector<char>& keep,
                  const std::function<bool()>& stop) {
  const Supersets implied(core.seers, core.seen);
  for (int i = 0; i < core.samples(); ++i) {
    if (stop && stop()) return;
    if (!keep[i]) continue;
    implied.each(i, [&](int other) {
      const bool equal = core.demand[other] == core.demand[i] &&
                         core.seers[other].size() == core.seers[i].size();
      if (core.demand[other] <= core.demand[i] && !(equal && other < i))
        keep[other] = 0;
      return true;
    });
  }
}

/// Candidates that others replace.
void drop_candidates(const CoverCore& core, std::vector<char>& keep,
                     const std::function<bool()>& stop) {
  const Supersets better(core.seen, core.seers);
  for (int j = 0; j < core.candidates(); ++j) {
    if (stop && stop()) return;
    int need = 0;
    for (const int i : core.seen[j]) need = std::max(need, core.demand[i]);
    if (need == 0) keep[j] = 0;
    better.each(j, [&](int k) {
      const bool equal =
          core.cost[k] == core.cost[j] && core.seen[k].size() == core.seen[j].size();
      if (core.cost[k] > core.cost[j] || (equal && k > j)) return true;
      const bool same_group = core.group[k] >= 0 && core.group[k] == core.group[j];
      if (same_group)
        need = 0;
      else if (core.group[k] < 0)
        --need;
      if (need <= 0) keep[j] = 0;
      return need > 0;
    });
  }
}

bool any_gone(const std::vector<char>& keep) {
  return std::find(keep.begin(), keep.end(), 0) != keep.end();
}

std::vector<char> demanding(const CoverCore& core) {
  std::vector<char> keep(core.samples());
  for (int i = 0; i < core.samples(); ++i) keep[i] = core.demand[i] > 0;
  return keep;
}

/// Groups of which one is left are none.
void dissolve_groups(std::vector<int>& group) {
  std::unordered_map<int, int> members;
  for (const int g : group) ++members[g];
  for (int& g : group)
    if (members[g] == 1) g = -1;
}

CoverCore without(CoverCore core, const std::vector<char>& keep_candidate,
                  const std::vector<char>& keep_sample) {
  std::vector<int> candidates, samples, number(core.samples(), -1);
  for (int i = 0; i < core.samples(); ++i) {
    if (!keep_sample[i]) continue;
    number[i] = static_cast<int>(samples.size());
    samples.push_back(i);
  }
  for (int j = 0; j < core.candidates(); ++j)
    if (keep_candidate[j]) candidates.push_back(j);
  const auto pick = [](auto& values, const std::vector<int>& which) {
    for (std::size_t k = 0; k < which.size(); ++k) values[k] = values[which[k]];
    values.resize(which.size());
  };
  core.seers = {};  // gigabytes, in large ones
  if (any_gone(keep_candidate) || any_gone(keep_sample))
    core.seen = selected(core.seen, candidates, number);
  core.seers = transposed(core.seen, static_cast<int>(samples.size()));
  pick(core.cost, candidates);
  pick(core.group, candidates);
  pick(core.candidate, candidates);
  pick(core.demand, samples);
  pick(core.sample, samples);
  dissolve_groups(core.group);
  return core;
}

}  // namespace

std::vector<int> unmet(const CoverCore& core) {
  std::vector<int> samples;
  for (int i = 0; i < core.samples(); ++i)
    if (seers_at_most(core, i, core.demand[i]) < core.demand[i]) samples.push_back(i);
  return samples;
}

CoverCore with_chosen(CoverCore core, int candidate) {
  std::vector<char> keep(core.candidates(), 1);
  choose(core, candidate, keep);
  return with_only(std::move(core), keep);
}

CoverCore with_only(CoverCore core, const std::vector<char>& keep) {
  const std::vector<char> samples = demanding(core);
  return without(std::move(core), keep, samples);
}

CoverCore core_of(const CoverProblem& problem) {
  CoverCore core;
  const int n = problem.candidates();
  core.seen.start = problem.start;
  core.seen.items = problem.seen;
  core.cost = problem.cost;
  core.demand = problem.demand;
  core.group = problem.group.empty() ? std::vector<int>(n, -1) : problem.group;
  core.candidate.resize(n);
  core.sample.resize(problem.samples);
  std::iota(core.candidate.begin(), core.candidate.end(), 0);
  std::iota(core.sample.begin(), core.sample.end(), 0);
  std::vector<char> keep(n, 1);
  for (int j = 0; j < n && !problem.fixed.empty(); ++j) {
    if (problem.fixed[j] == Membership::out) keep[j] = 0;
    if (problem.fixed[j] == Membership::in) choose(core, j, keep);
  }
  return with_only(std::move(core), keep);
}

CoverCore reduced(CoverCore core, const std::function<bool()>& stop) {
  for (bool more = true; more && !(stop && stop());) {
    std::vector<char> keep(core.candidates(), 1);
    force(core, keep);
    std::vector<char> keep_sample = demanding(core);
    drop_samples(core, keep_sample, stop);
    more = any_gone(keep) || any_gone(keep_sample);
    if (more) core = without(std::move(core), keep, keep_sample);
    keep.assign(core.candidates(), 1);
    drop_candidates(core, keep, stop);
    if (!any_gone(keep)) continue;
    more = true;
    core = with_only(std::move(core), keep);
  }
  return core;
}

}  // namespace delos
