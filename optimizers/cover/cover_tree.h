// Enumeration of the covers that a bound leaves.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "cover/cover_core.h"

namespace delos {

/// Whether no cover of at least this cost can be cheaper than the limit: by a rounding,
/// or, where all costs are whole, by less than one.
[[nodiscard]] bool reaches(double bound, double limit, bool whole);

/// Branch and bound, depth first. At a node: reductions, steps of the Lagrangian from
/// the parent's multipliers, candidates out whose reduced cost reaches the limit. It
/// branches over who is the first, by reduced cost, to see the sample that fewest can
/// see.
///
/// Where costs are whole, covers of the bound's cost are looked for, then of one more,
/// and so on: so the bound rises while it runs.
class CoverTree {
 public:
  /// @param bound no cover costs less
  /// @param multipliers to begin with, one a sample of the core
  CoverTree(const CoverCore& core, double bound, const std::vector<double>& multipliers,
            bool whole);

  /// Go on until about `work` list entries were read.
  /// @param limit only covers that cost less are looked for; no more than before
  void run(std::int64_t work, double limit);

  [[nodiscard]] bool done() const { return done_; }      ///< no cheaper cover is left
  [[nodiscard]] double bound() const { return bound_; }  ///< of all covers
  /// The best cover so far, numbers of the problem; ∞: none.
  [[nodiscard]] const std::vector<int>& best() const { return best_; }
  [[nodiscard]] double best_cost() const { return best_cost_; }

 private:
  /// A node whose children are visited in turn: the next of `order` chosen, those
  /// before it out.
  struct Node {
    CoverCore core;
    std::vector<double> multipliers;
    std::vector<int> order;
    std::size_t next = 0, last = 0;
  };

  void visit(const CoverCore& core, const std::vector<double>& multipliers);
  void visit_child(Node& node);
  void branch(CoverCore core, std::vector<double> multipliers,
              const std::vector<double>& reduced_costs);
  [[nodiscard]] std::vector<double> inherited(const CoverCore& from,
                                              const std::vector<double>& multipliers,
                                              const CoverCore& to);
  void begin();

  CoverCore root_;
  std::vector<double> root_multipliers_;
  bool whole_;
  double bound_, target_ = 0, limit_ = std::numeric_limits<double>::infinity();
  std::vector<Node> path_;
  std::vector<double> of_sample_;  ///< multipliers by the problem's numbers
  std::vector<int> best_;
  double best_cost_ = std::numeric_limits<double>::infinity();
  std::int64_t work_ = 0;
  bool begun_ = false, done_ = false;
};

}  // namespace delos
