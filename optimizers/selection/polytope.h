// Fractions of candidates that a selection allows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace delos {

/// What has been decided of a candidate.
enum class Decision : std::int8_t { open, in, out };

/// What choices must keep: costs within a budget, at most one of each spot.
struct ChoiceRules {
  std::vector<double> cost;  ///< of each candidate, > 0
  std::vector<int> spot;     ///< of each; −1: of none
  double budget = 0;

  [[nodiscard]] std::size_t size() const { return cost.size(); }
  /// @param chosen one flag a candidate
  [[nodiscard]] bool allow(std::span<const char> chosen) const;
};

/// All fractional choices w that the rules and some decisions allow,
///
///     0 ≤ w ≤ 1,   Σ c w ≤ budget,   Σ_spot w ≤ 1,   decided ones 0 or 1
class ChoicePolytope {
 public:
  /// Candidates that no longer fit beside those decided to be in are out.
  ChoicePolytope(const ChoiceRules& rules, std::vector<Decision> decisions);

  /// Whether the decisions keep the rules by themselves.
  [[nodiscard]] bool feasible() const { return feasible_; }
  /// The decisions, with what follows from them.
  [[nodiscard]] const std::vector<Decision>& decisions() const { return decisions_; }
  /// The candidates that are still open.
  [[nodiscard]] const std::vector<std::size_t>& open() const { return open_; }
  /// What the budget leaves for them.
  [[nodiscard]] double left() const { return left_; }

  /// The nearest point.
  /// @param[in,out] w one number a candidate
  void project(std::span<double> w) const;

  /// A lower bound of g·w over the polytope, and how much it rises where a candidate is
  /// decided otherwise, by Lagrange's multiplier μ ≥ 0 of the budget:
  ///
  ///     Σ_in g − μ left + Σ_spots min(0, min_i (g_i + μ c_i))
  ///
  /// with candidates of no spot as spots of one. Equal to the minimum at the best μ.
  struct LinearBound {
    double value = 0;
    std::vector<double> if_in, if_out;  ///< rises, ≥ 0, of open candidates; else 0
  };
  /// @param g slopes, one a candidate
  [[nodiscard]] LinearBound linear_bound(std::span<const double> g) const;

 private:
  /// Limit to [0, 1] and to one a spot.
  void project_spots(std::span<double> w) const;

  const ChoiceRules& rules_;
  std::vector<Decision> decisions_;
  std::vector<std::size_t> open_;
  std::vector<std::vector<std::size_t>> spots_;  ///< open candidates of each spot
  double left_ = 0;
  bool feasible_ = true;
};

}  // namespace delos
