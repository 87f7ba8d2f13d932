// A convex cost of fractional choices.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace delos {

/// What a convex function f of w is near one point.
struct Tangent {
  double smooth = 0;          ///< f̃(w) ≥ f(w), which has slopes
  std::vector<double> slope;  ///< ∂f̃/∂w, ≤ 0
  /// f(v) ≥ level + slope·(v − w) for every v.
  double level = 0;
};

/// One candidate in, another out; kNobody: none.
struct Change {
  static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);
  std::size_t in = kNobody, out = kNobody;
};

/// What a choice costs for every direction that it leaves blind somewhere, times the
/// weight of the sample: so much that whatever sees everything costs less.
inline constexpr double kBlindCost = 1e200;
/// Whether what costs so much leaves something blind.
[[nodiscard]] inline bool is_blind(double cost) { return cost > 1e100; }

/// f(w) ≥ 0, convex and falling in every w. Not thread-safe.
class ChoiceCost {
 public:
  virtual ~ChoiceCost() = default;
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// f(w); blind where something isn't observed.
  [[nodiscard]] virtual double value(std::span<const double> w) = 0;
  /// f of a whole choice after each of some changes.
  /// @param chosen one flag a candidate
  [[nodiscard]] virtual std::vector<double> changed(
      std::span<const char> chosen, std::span<const Change> changes) = 0;
  /// @param sharpness how near f̃ is to f where f has kinks, > 0
  /// @returns false where there is none: f(w) is blind, or too nearly so
  virtual bool tangent(std::span<const double> w, double sharpness, Tangent& out) = 0;
  /// Candidates that can't be in by a fraction: tangent() takes them to be in unless
  /// they are excluded, so that it stays below.
  [[nodiscard]] virtual const std::vector<std::size_t>& whole_ones() const = 0;
  /// @param out one flag a candidate: it isn't chosen
  virtual void exclude(std::span<const char> out) = 0;
};

}  // namespace delos
