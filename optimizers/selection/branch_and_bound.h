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

/// Choices that have some decisions in common, not yet looked into.
struct BranchNode {
  double bound = 0;        ///< none of them costs less
  std::size_t number = 0;  ///< when it was made: ties are broken by it
  std::vector<Decision> decisions;
  std::vector<double> w;  ///< where the relaxation was least
};

/// A search that can be taken up again.
struct BranchState {
  Choice best;        ///< nothing chosen: the search hasn't begun
  double closed = 0;  ///< the least bound of what needn't be looked into
  std::size_t nodes = 0;
  std::vector<BranchNode> open;  ///< in any order
  Relaxation root;               ///< without decisions: the fractions and the proof
};

/// When to be satisfied.
struct BranchOptions {
  double gap = 0;              ///< best ≤ (1 + gap) bound is enough
  std::uint64_t seed = 1;      ///< of the choices that are tried first
  int tries = 8;               ///< so many of them
  std::vector<char> first;     ///< a choice that is tried before; empty: none
  std::function<bool()> stop;  ///< asked often
  std::function<void(const BranchProgress&)> progress;
  /// Called now and then, and at the end, with what resume() needs.
  std::function<void(const BranchState&)> save;
  double save_every = 10;  ///< seconds, about
};

/// What branch and bound found.
struct BranchResult {
  Choice best;
  double bound = 0;
  std::size_t nodes = 0;
  bool stopped = false;  ///< before the gap was reached
  Relaxation root;       ///< see BranchState
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

/// The same, from where a search was saved.
[[nodiscard]] BranchResult resume_branches(ChoiceCost& cost, const ChoiceRules& rules,
                                           BranchState state,
                                           const BranchOptions& options);

}  // namespace delos
