#include "selection/relaxation.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "delos/model/infinity.h"

namespace delos {
namespace {

/// Rounding of sums over samples may lift a bound by so much, relatively.
constexpr double kLevelRounding = 1e-10;
/// Stages of sharpness where f has kinks; smooth costs don't notice.
constexpr double kSharpnesses[] = {30, 150, 800};

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// The state of one search.
class ConvexDescent {
 public:
  ConvexDescent(ChoiceCost& cost, const ChoicePolytope& polytope,
                const RelaxationOptions& options)
      : cost_(cost), polytope_(polytope), options_(options) {
    // No cost is below zero; whatever else is decided, it may be that.
    best.value = kInfinity;
    best.bound = 0;
    best.linear.if_in.assign(cost.size(), 0.0);
    best.linear.if_out.assign(cost.size(), 0.0);
  }

  bool begin(std::vector<double> start) {
    polytope_.project(start);
    best.w = start;
    const std::size_t n = start.size();
    // Every open candidate has a part of the budget, so that all that can be seen is.
    std::vector<double> even(n, 0.0);
    const auto open = static_cast<double>(polytope_.open().size());
    for (const std::size_t i : polytope_.open()) even[i] = std::min(1.0, 1 / open);
    for (const double mix : {0.0, 0.05, 1.0}) {
      std::vector<double> w(n);
      for (std::size_t i = 0; i < n; ++i) w[i] = (1 - mix) * start[i] + mix * even[i];
      polytope_.project(w);
      if (evaluate(w, tangent_, kSharpnesses[0])) {
        w_ = std::move(w);
        return true;
      }
    }
    return false;
  }

  void descend(double sharpness) {
    if (!evaluate(w_, tangent_, sharpness)) return;
    std::deque<double> recent = {tangent_.smooth};
    double step = 0;
    std::vector<double> direction(w_.size()), to(w_.size());
    Tangent next;
    while (taken_ < options_.steps && !satisfied()) {
      ++taken_;
      if (step == 0) step = first_step();
      for (std::size_t i = 0; i < w_.size(); ++i)
        direction[i] = w_[i] - step * tangent_.slope[i];
      polytope_.project(direction);
      for (std::size_t i = 0; i < w_.size(); ++i) direction[i] -= w_[i];
      const double fall = dot(tangent_.slope, direction);
      if (!(fall < -1e-14 * tangent_.smooth)) break;
      const double reference = *std::max_element(recent.begin(), recent.end());
      double length = 1;
      bool found = false;
      for (int halving = 0; halving < 30 && !found; ++halving) {
        for (std::size_t i = 0; i < w_.size(); ++i)
          to[i] = w_[i] + length * direction[i];
        found = evaluate(to, next, sharpness) &&
                next.smooth <= reference + 1e-4 * length * fall;
        if (!found) length /= 2;
      }
      if (!found) break;
      double yy = 0, sy = 0, ss = 0;
      for (std::size_t i = 0; i < w_.size(); ++i) {
        const double s = to[i] - w_[i], y = next.slope[i] - tangent_.slope[i];
        ss += s * s;
        sy += s * y;
        yy += y * y;
      }
      // Long and short steps in turn do better than either.
      const double longest = 1e6 * first_step();
      step = sy > 0 ? (taken_ % 2 ? ss / sy : sy / yy) : longest;
      step = std::clamp(step, 1e-10 * longest, longest);
      w_ = to;
      std::swap(tangent_, next);
      recent.push_back(tangent_.smooth);
      if (recent.size() > 8) recent.pop_front();
    }
  }

  [[nodiscard]] bool satisfied() const {
    return (options_.cutoff > 0 && best.bound >= options_.cutoff) ||
           best.value - best.bound <= options_.tolerance * best.value ||
           (options_.stop && options_.stop());
  }

  Relaxation best;

 private:
  bool evaluate(std::span<const double> w, Tangent& out, double sharpness) {
    if (!cost_.tangent(w, sharpness, out)) return false;
    ChoicePolytope::LinearBound linear = polytope_.linear_bound(out.slope);
    const double at = dot(out.slope, w);
    const double bound = out.level + linear.value - at -
                         kLevelRounding * (std::abs(out.level) + std::abs(at));
    if (bound > best.bound) {
      best.bound = bound;
      best.linear = std::move(linear);
    }
    if (out.smooth < best.value) {
      best.value = out.smooth;
      best.w.assign(w.begin(), w.end());
    }
    return true;
  }

  /// A step that would move the steepest candidate by one.
  [[nodiscard]] double first_step() const {
    double steepest = 0;
    for (const std::size_t i : polytope_.open())
      steepest = std::max(steepest, std::abs(tangent_.slope[i]));
    return steepest > 0 ? 1 / steepest : 1;
  }

  ChoiceCost& cost_;
  const ChoicePolytope& polytope_;
  const RelaxationOptions& options_;
  std::vector<double> w_;
  Tangent tangent_;
  int taken_ = 0;
};

}  // namespace

Relaxation relax(ChoiceCost& cost, const ChoicePolytope& polytope,
                 std::vector<double> start, const RelaxationOptions& options) {
  ConvexDescent search(cost, polytope, options);
  if (!search.begin(std::move(start))) {
    // Nothing can be said, but where not even all together see everything.
    std::vector<double> all(cost.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = polytope.decisions()[i] != Decision::out;
    search.best.value = kInfinity;
    search.best.bound = is_blind(cost.value(all)) ? kInfinity : 0;
    return search.best;
  }
  for (const double sharpness : kSharpnesses) {
    if (search.satisfied()) break;
    search.descend(sharpness);
  }
  return search.best;
}

}  // namespace delos
