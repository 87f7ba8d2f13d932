// A bound on covers by Lagrangian relaxation of what samples demand.
#pragma once

#include <vector>

#include "cover/cover_core.h"

namespace delos {

/// Ascent of the dual function
///
///   L(u) = Σ_i d_i u_i + Σ_j min(0, r_j),   r_j = c_j − Σ_{i ∈ S(j)} u_i,   u ≥ 0
///
/// where of each group only the least r_j counts. No cover costs less than L(u), nor
/// less than L(u) + r_j if it has a candidate j with r_j > 0. Sources: Held, Karp
/// (1971), Math. Program. 1, 6–25; Caprara, Fischetti, Toth (1999), Oper. Res. 47(5),
/// 730–743, sec. 3: step lengths.
///
/// Without multipliers to begin with, u_i = min_{j ∋ i} c_j/|S(j)|, for which all
/// r_j ≥ 0; the first steps let every u_i grow as far as no r_j falls below 0, for as
/// long as that is worth it. Few steps of subgradients raise a bound so far.
class Lagrangian {
 public:
  /// @param start multipliers to begin with, one a sample; empty: as above
  explicit Lagrangian(const CoverCore& core, std::vector<double> start = {});

  /// One step; of a subgradient as long as for a cost that is reached; ∞: none is
  /// known.
  void step(double target);

  [[nodiscard]] double bound() const { return bound_; }  ///< the best so far
  [[nodiscard]] bool settled() const { return settled_; }
  /// @name at the best bound
  /// @{
  [[nodiscard]] const std::vector<double>& multipliers() const { return best_u_; }
  [[nodiscard]] const std::vector<double>& reduced_costs() const { return best_r_; }
  /// @}

 private:
  [[nodiscard]] double evaluate();
  void fill_up();
  void adapt(double value);

  const CoverCore& core_;
  std::vector<double> u_, r_, slope_, direction_;
  std::vector<int> least_;  ///< candidate of least r of each group
  std::vector<double> best_u_, best_r_;
  double bound_ = -1e300;
  double length_;  ///< λ
  int patience_;   ///< steps without a better bound, until λ halves
  int idle_ = 0;   ///< such steps
  bool settled_ = false;
  bool filling_ = false;  ///< u grows within r ≥ 0
};

}  // namespace delos
