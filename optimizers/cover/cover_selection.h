// Candidates selected for a cover, what each is worth, and what exchanges would change.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "cover/cover_core.h"

namespace delos {

/// A selection of a core's candidates under change. Samples have weights w:
///
///   gain(j) = Σ w_i / c_j over the samples of j that are seen too few times
///   loss(k) = Σ w_i / c_k over the samples of k that would be without it,   k selected
///
/// both kept up to date with every change. Steps are counted by the searcher.
class CoverSelection {
 public:
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  struct Exchange {
    int in = -1, out = -1;
    double value = -kNone;  ///< gain(in) − loss(out), the loss once `in` is selected
  };

  /// Begins with the greedy cover without what is redundant; groups may leave none.
  explicit CoverSelection(const CoverCore& core);

  [[nodiscard]] bool has(int j) const { return place_[j] >= 0; }
  [[nodiscard]] const std::vector<int>& selected() const { return selected_; }
  [[nodiscard]] double cost() const { return cost_; }
  /// Samples that are seen too few times.
  [[nodiscard]] const std::vector<int>& missed() const { return missed_; }
  [[nodiscard]] double gain(int j) const { return gain_[j] * per_cost_[j]; }
  [[nodiscard]] double loss(int k) const { return loss_[k] * per_cost_[k]; }
  /// The selected candidate of j's group; −1: none.
  [[nodiscard]] int member(int j) const {
    return core_.group[j] < 0 ? -1 : member_[core_.group[j]];
  }
  /// What selecting j gains for its cost, less what the group's member leaves.
  [[nodiscard]] double value(int j) const;
  /// The selected candidate of least loss, of equal ones the one that moved first.
  [[nodiscard]] int least_loss() const;
  /// The step in which j moved last.
  [[nodiscard]] std::int64_t moved(int j) const { return moved_[j]; }

  /// Select j in a step, in place of its group's member.
  void put(int j, std::int64_t step);
  /// Deselect k in a step.
  void take(int k, std::int64_t step);
  /// Let the weights of all missed samples grow by one.
  void weigh_missed();
  /// Where nothing is missed: deselect what isn't needed, and keep the cover if none
  /// was cheaper.
  void note_cover();

  /// Note what exchanges may take away: what moved last before a step. Holds until the
  /// selection changes.
  void open_losses(std::int64_t before);
  /// The exchange that selects j and deselects whom that costs least; of j's group: its
  /// member, at any time. `out` is −1 where none may go.
  /// @param worth exchanges of less value don't matter: their `out` isn't looked for
  [[nodiscard]] Exchange exchange_for(int j, double worth);

  /// The cheapest cover so far, numbers of the core; empty and ∞: none.
  [[nodiscard]] const std::vector<int>& best() const { return best_; }
  [[nodiscard]] double best_cost() const { return best_cost_; }
  /// List entries read so far.
  [[nodiscard]] std::int64_t work() const { return work_; }

 private:
  /// Numbers that stand for no candidate: many, since what is noted for one of them
  /// would have to wait for what was noted for it just before.
  static constexpr int kNobodies = 8;
  [[nodiscard]] int nobody(int i) const {
    return core_.candidates() + 1 + i % kNobodies;
  }

  void now_missed(int i);
  void no_longer_missed(int i);
  int recount(int i);
  void change_gains(int i, double by);
  void select(int j);
  void deselect(int j);
  void greedy();
  void clean();

  const CoverCore& core_;
  int several_;                            ///< stands for all holders in sole_
  std::vector<int> count_;                 ///< selected seers of each sample
  std::vector<std::vector<int>> holders_;  ///< who they are
  std::vector<int>
      sole_;  ///< who alone keeps the demand of a sample, or all its holders
  std::vector<double> weight_;         ///< of each sample, a whole number
  std::vector<double> gain_, loss_;    ///< of candidates, times their cost
  std::vector<double> per_cost_;       ///< 1/c of each candidate
  std::vector<double> open_loss_;      ///< loss of each candidate; ∞: may not go
  std::vector<double> left_;           ///< of it, once the candidate under test is in
  Exchange least_;                     ///< the least open loss as its value
  std::vector<std::int64_t> moved_;    ///< the step in which each candidate moved last
  std::vector<int> selected_, place_;  ///< the selection; where each is in it, −1: not
  std::vector<int> missed_, missed_place_;
  std::vector<int> member_;  ///< selected candidate of each group, −1: none
  double cost_ = 0;
  std::vector<int> best_;
  double best_cost_ = kNone;
  std::int64_t work_ = 0;
};

}  // namespace delos
