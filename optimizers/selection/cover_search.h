// Local search for a cheaper cover, by weights on samples that stay unseen.
#pragma once

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "selection/cover_core.h"

namespace delos {

/// A walk through selections that are cheaper than the best cover, and miss some
/// samples.
///
///   gain(j) = Σ w_i over the samples of j that are seen too few times,    j not
///   selected loss(k) = Σ w_i over the samples of k that would be seen too few times
///   without it
///
/// A step draws a sample from the missed ones. Of the candidates j that see it, it
/// selects that of most gain(j)/c_j, if that stays cheaper than the best cover; else it
/// exchanges the pair of most gain(j)/c_j − loss(k)/c_k, the loss once j is selected.
/// What has just moved stays; of a group, one takes the other's place. Where a step's
/// value isn't positive, the weights w of all missed samples grow by one. Sources: Gao,
/// Weise, Li (2015), Eur. J. Oper. Res. 246(3), 750–761: weights of samples; Zhang, Lü,
/// Su, Li, et al. (2020), IJCAI, 1481–1487: exchanges of pairs, weights in local optima
/// only. Here with demands, costs and groups.
class CoverSearch {
 public:
  /// Begins with the greedy cover without what is redundant; groups may leave none.
  CoverSearch(const CoverCore& core, std::uint64_t seed);

  /// Search on until about `work` list entries were read, or a cover costs `enough`.
  /// @param limit only covers that cost less are looked for
  void run(std::int64_t work, double limit, double enough);

  /// The best cover so far, numbers of the core; empty and ∞: none.
  [[nodiscard]] const std::vector<int>& best() const { return best_; }
  [[nodiscard]] double best_cost() const { return best_cost_; }
  [[nodiscard]] std::int64_t moves() const { return moves_; }

 private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  struct Exchange {
    int in = -1, out = -1;
    double value = 0;
  };

  void now_missed(int i);
  void no_longer_missed(int i);
  int recount(int i);
  void select(int j);
  void deselect(int j);
  void put(int j);
  void take(int j);
  [[nodiscard]] double value(int j) const;
  [[nodiscard]] int least_loss() const;
  [[nodiscard]] int most_gain(int sample, double limit) const;
  [[nodiscard]] Exchange exchange_for(int j);
  [[nodiscard]] Exchange best_exchange(int sample);
  void greedy();
  void clean();
  void note_cover();
  void step(double limit);

  const CoverCore& core_;
  int nobody_, several_;          ///< stand for candidates in sole_
  std::vector<double> per_cost_;  ///< 1/c of each candidate
  std::mt19937_64 random_;
  std::vector<int> count_;                 ///< selected seers of each sample
  std::vector<std::vector<int>> holders_;  ///< who they are
  std::vector<int>
      sole_;  ///< who alone keeps the demand of a sample, or all its holders
  std::vector<std::int64_t> weight_;   ///< of each sample
  std::vector<std::int64_t> score_;    ///< gain or loss of each candidate
  std::vector<std::int64_t> spared_;   ///< of losses, by a candidate under test
  std::vector<std::int64_t> moved_;    ///< the step in which each candidate moved last
  std::vector<int> selected_, place_;  ///< the selection; where each is in it, −1: not
  std::vector<int> missed_, missed_place_;
  std::vector<int> member_;  ///< selected candidate of each group, −1: none
  double cost_ = 0;
  std::vector<int> best_;
  double best_cost_ = kNone;
  std::int64_t moves_ = 0, work_ = 0;
};

}  // namespace delos
