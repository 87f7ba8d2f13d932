// The best whole choice, with a proof of how good it is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "selection/exchange.h"
#include "selection/relaxation.h"

namespace delos {

/// How far a search for the best choice is.
struct BranchProgress {
  double best = 0;   ///< cost of the best choice so far; +∞: none yet
  double bound = 0;  ///< no choice costs less
  std::size_t nodes = 0;
};

/// When to be satisfied.
struct BranchOptions {
  double gap = 0;              ///< best ≤ (1 + gap) bound is enough
  std::uint64_t seed = 1;      ///< of the choices that are tried first
  int tries = 8;               ///< so many of them
  std::function<bool()> stop;  ///< asked often
  std::function<void(const BranchProgress&)> progress;
};

/// What branch and bound found.
struct BranchResult {
  Choice best;
  double bound = 0;
  std::size_t nodes = 0;
  bool stopped = false;  ///< before the gap was reached
  /// Of the relaxation without decisions: the fractions and the proof.
  Relaxation root;
};

/// Minimise the cost over all whole choices that the rules allow.
///
/// Relaxations bound, rounding and exchanges find choices, candidates are decided where
/// the bound's slopes prove it, and the node of the least bound is split in two at its
/// most undecided candidate.
/// @param decisions taken in advance
/// @pre the decisions keep the rules
[[nodiscard]] BranchResult branch_and_bound(ChoiceCost& cost, const ChoiceRules& rules,
                                            const std::vector<Decision>& decisions,
                                            const BranchOptions& options);

}  // namespace delos
