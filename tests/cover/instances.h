// Random covering problems, and their optimum by enumeration.
#pragma once

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "delos/optimize/cover.h"

namespace delos::test {

/// What a random problem has beyond lists.
struct Variety {
  int samples = 12, candidates = 12;
  double density = 0.3;
  int most_demand = 1;
  bool costs = false, whole = true;  ///< costs of 1 to 9, or reals
  bool groups = false, fixed = false;
};

inline CoverProblem random_cover(const Variety& v, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % n); };
  CoverProblem p;
  p.samples = v.samples;
  for (int j = 0; j < v.candidates; ++j) {
    for (int i = 0; i < v.samples; ++i)
      if (below(1000) < 1000 * v.density) p.seen.push_back(i);
    p.start.push_back(static_cast<std::int64_t>(p.seen.size()));
    const double real = 0.5 + 1e-3 * below(3000);
    p.cost.push_back(!v.costs ? 1 : v.whole ? 1 + below(9) : real);
    if (v.groups) p.group.push_back(below(3) == 0 ? -1 : below(v.candidates / 3));
    if (v.fixed) {
      const int kind = below(10);
      p.fixed.push_back(kind == 0   ? Membership::in
                        : kind == 1 ? Membership::out
                                    : Membership::free);
    }
  }
  for (int i = 0; i < v.samples; ++i) p.demand.push_back(1 + below(v.most_demand));
  return p;
}

/// Candidates that see `each` samples and none twice, so that they are the fewest,
/// behind `decoys` others that see as many at random.
inline CoverProblem hidden_partition(int samples, int each, int decoys,
                                     std::uint64_t seed) {
  CoverProblem p;
  p.samples = samples;
  p.demand.assign(samples, 1);
  std::mt19937_64 random(seed);
  std::vector<int> order(samples);
  std::iota(order.begin(), order.end(), 0);
  for (int j = 0; j < decoys + samples / each; ++j) {
    const int first = j < decoys ? 0 : each * (j - decoys);
    // Fisher and Yates, since std::shuffle's order differs between libraries.
    for (int i = samples - 1; i > 0 && j <= decoys; --i)
      std::swap(order[i], order[random() % (i + 1)]);
    std::vector<int> seen(order.begin() + first, order.begin() + first + each);
    std::sort(seen.begin(), seen.end());
    p.seen.insert(p.seen.end(), seen.begin(), seen.end());
    p.start.push_back(static_cast<std::int64_t>(p.seen.size()));
    p.cost.push_back(1);
  }
  return p;
}

/// The least cost of all 2ⁿ selections that are covers, each looked at by the
/// definition; ∞: none is.
inline double enumerated(const CoverProblem& p) {
  double least = std::numeric_limits<double>::infinity();
  const int n = p.candidates();
  int groups = 0;
  for (const int g : p.group) groups = std::max(groups, g + 1);
  std::vector<int> count, member;
  for (unsigned chosen = 0; chosen < 1u << n; ++chosen) {
    double cost = 0;
    bool allowed = true;
    count.assign(p.samples, 0);
    member.assign(groups, 0);
    for (int j = 0; j < n && allowed; ++j) {
      const bool in = (chosen >> j & 1u) != 0;
      if (!p.fixed.empty() && p.fixed[j] != Membership::free)
        allowed = in == (p.fixed[j] == Membership::in);
      if (!in) continue;
      cost += p.cost[j];
      if (!p.group.empty() && p.group[j] >= 0 && ++member[p.group[j]] > 1)
        allowed = false;
    }
    if (!allowed || cost >= least) continue;
    for (int j = 0; j < n; ++j) {
      if ((chosen >> j & 1u) == 0) continue;
      for (auto k = p.start[j]; k < p.start[j + 1]; ++k) ++count[p.seen[k]];
    }
    for (int i = 0; i < p.samples && allowed; ++i) allowed = count[i] >= p.demand[i];
    if (allowed) least = cost;
  }
  return least;
}

}  // namespace delos::test
