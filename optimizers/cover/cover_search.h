// Local search for a cheaper cover, by weights on samples that stay unseen.
#pragma once

#include <cstdint>
#include <random>

#include "cover/cover_selection.h"

namespace delos {

/// A walk through selections that are cheaper than the best cover, and miss some
/// samples.
///
/// A step draws a sample from the missed ones. Of the candidates that see it, it
/// selects that of most gain, if that stays cheaper than the best cover; else it makes
/// the exchange of most value. What has just moved stays; of a group, one takes the
/// other's place. Where a step's value isn't positive, the weights of all missed
/// samples grow by one. Sources: Gao, Weise, Li (2015), Eur. J. Oper. Res. 246(3),
/// 750–761: weights of samples; Zhang, Lü, Su, Li, et al. (2020), IJCAI, 1481–1487:
/// exchanges of pairs, weights in local optima only. Here with demands, costs and
/// groups.
class CoverSearch {
 public:
  /// @param begin where the walk begins, of this core
  CoverSearch(const CoverCore& core, CoverSelection begin, std::uint64_t seed);

  /// Search on until about `work` list entries were read, or a cover costs `enough`.
  /// @param limit only covers that cost less are looked for
  void run(std::int64_t work, double limit, double enough);

  [[nodiscard]] const CoverSelection& selection() const { return selection_; }
  [[nodiscard]] std::int64_t moves() const { return moves_; }

 private:
  [[nodiscard]] int most_gain(int sample, double limit) const;
  [[nodiscard]] CoverSelection::Exchange best_exchange(int sample);
  void step(double limit);

  const CoverCore& core_;
  CoverSelection selection_;
  std::mt19937_64 random_;
  std::int64_t moves_ = 0, looked_ = 0;
};

}  // namespace delos
