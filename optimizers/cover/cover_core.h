// What is left of a covering problem once the obvious is decided.
#pragma once

#include <functional>
#include <vector>

#include "cover/incidence.h"
#include "delos/optimize/cover.h"

namespace delos {

/// A covering problem whose candidates are all free; numbers are its own.
struct CoverCore {
  Lists seen;                  ///< samples of each candidate
  Lists seers;                 ///< candidates of each sample
  std::vector<double> cost;    ///< of each candidate
  std::vector<int> demand;     ///< of each sample, ≥ 1
  std::vector<int> group;      ///< of each candidate; −1: none
  std::vector<int> candidate;  ///< number in the problem of each candidate
  std::vector<int> sample;     ///< number in the problem of each sample
  std::vector<int> chosen;     ///< decided: numbers in the problem
  double chosen_cost = 0;

  [[nodiscard]] int samples() const { return static_cast<int>(demand.size()); }
  [[nodiscard]] int candidates() const { return seen.size(); }
};

/// Samples that too few candidates see, of a group only one counted.
[[nodiscard]] std::vector<int> unmet(const CoverCore& core);

/// What remains after candidates fixed in and out; groups of one are none.
[[nodiscard]] CoverCore core_of(const CoverProblem& problem);

/// The core without what an optimum can do without, until nothing more is found:
///   a sample that sample i′ implies,    C(i′) ⊆ C(i), d(i) ≤ d(i′);
///   a candidate j that others replace:  S(j) ⊆ S(k), c(k) ≤ c(j), with k of j's group
///   or max d over S(j) such k without a group.
/// A candidate without which a sample's demand can't be met is chosen.
/// Source: Caprara, Toth, Fischetti (2000), Ann. Oper. Res. 98, 353–371, sec. 2, with
/// demands.
/// @param stop asked again and again: whether what was found so far is enough
[[nodiscard]] CoverCore reduced(CoverCore core, const std::function<bool()>& stop = {});

/// The core with a candidate chosen.
[[nodiscard]] CoverCore with_chosen(CoverCore core, int candidate);

/// The core of those candidates alone that are kept, and what they leave of demands.
[[nodiscard]] CoverCore with_only(CoverCore core, const std::vector<char>& keep);

}  // namespace delos
