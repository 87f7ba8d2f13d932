// Steady state of an update, or of a cycle of updates.
#include <array>
#include <cstdlib>
#include <vector>

#include "delos/riccati/riccati.h"
#include "riccati/balance.h"
#include "riccati/fixed_point.h"
#include "riccati/linear.h"
#include "riccati/observability.h"

namespace delos {
namespace {

using namespace riccati;

bool fits(const StateMatrix& m, Eigen::Index rows, Eigen::Index cols) {
  return m.rows() == rows && m.cols() == cols;
}

void require_sizes(std::span<const CycleStep> cycle) {
  const Eigen::Index n = cycle.empty() ? 0 : cycle[0].motion.A.rows();
  if (n < 1) std::abort();
  for (const auto& [motion, measurement] : cycle) {
    const StateMatrix& C = measurement.exact;
    if (!fits(motion.A, n, n) || !fits(motion.Q, n, n) ||
        !fits(measurement.information, n, n) || (C.rows() > 0 && C.cols() != n) ||
        (measurement.rows.rows() > 0 && measurement.rows.cols() != n))
      std::abort();
  }
}

/// Π after a cycle by plain recursion, for exact rows that see more than one step's
/// noise drives, where no doubling map exists. Converges linearly: the remaining change
/// is estimated from the ratio of the last two.
FixedPoint recursion(std::span<const CycleStep> cycle) {
  constexpr int kMaxCycles = 20000;
  constexpr double kSettled = 1e-14;
  const Eigen::Index n = cycle[0].motion.A.rows();
  FixedPoint result{StateMatrix::Identity(n, n)};
  double last = 0;
  for (int i = 0; i < kMaxCycles && !result.settled; ++i) {
    StateMatrix next = result.posterior;
    for (const auto& [motion, measurement] : cycle)
      next = update(predict(motion, next), measurement);
    const double change = (next - result.posterior).norm();
    const double ratio = last > 0 ? std::min(change / last, 1.0) : 1.0;
    result.settled = change * ratio <= kSettled * (1 - ratio) * next.norm() ||
                     change <= 1e-16 * next.norm();
    result.posterior = next;
    last = change;
  }
  return result;
}

FixedPoint cycle_fixed_point(std::span<const CycleStep> cycle) {
  bool regular = true;
  UpdateMap map;
  for (std::size_t j = 0; j < cycle.size() && regular; ++j) {
    const UpdateMap next = one_update(cycle[j].motion, cycle[j].measurement, regular);
    map = j == 0 ? next : compose(map, next);
  }
  return regular ? fixed_point(map) : recursion(cycle);
}

/// @param cycle balanced by D; reduced here to what is left of the state
void solve_balanced(std::span<CycleStep> cycle, const StateVector& D,
                    std::span<SteadyState> states) {
  const std::size_t count = cycle.size();
  // Bases of what is lost (and of the rest) after every step; the last one stands for
  // what is lost before the first.
  const StateMatrix lost = lost_directions(cycle, Stability::discrete);
  const bool complete = lost.cols() == 0;
  for (std::size_t j = 0; j < count; ++j) {
    const StateMatrix& before = j == 0 ? lost : states[j - 1].unobservable;
    states[j].unobservable =
        complete || j + 1 == count ? lost : orthonormal(cycle[j].motion.A * before);
  }
  if (!complete) {
    StateMatrix before = complement(lost);
    for (std::size_t j = 0; j < count; ++j) {
      const StateMatrix after = complement(states[j].unobservable);
      cycle[j] = quotient(cycle[j], before, after);
      before = after;
    }
  }

  const FixedPoint point = cycle_fixed_point(cycle);
  StateMatrix Pi = point.posterior;
  for (std::size_t j = 0; j < count; ++j) {
    SteadyState& state = states[j];
    StateMatrix P = predict(cycle[j].motion, Pi);
    Pi = update(P, cycle[j].measurement);
    state.doublings = point.doublings;
    state.status = !point.settled ? RiccatiStatus::iteration_limit
                   : complete     ? RiccatiStatus::converged
                                  : RiccatiStatus::unobservable;
    // Back from y = Vᵀ D⁻¹ x.
    StateMatrix X = D.asDiagonal();
    if (!complete) X = X * complement(state.unobservable);
    state.prior = congruence(X, P);
    state.posterior = congruence(X, Pi);
    if (complete) continue;
    state.unobservable = orthonormal(D.asDiagonal() * state.unobservable);
    state.prior = projected_off(state.prior, state.unobservable);
    state.posterior = projected_off(state.posterior, state.unobservable);
  }
}

}  // namespace

SteadyState solve_doubling(const MotionStep& motion, const Measurement& measurement) {
  std::array<CycleStep, 1> cycle{{{motion, measurement}}};
  require_sizes(cycle);
  const StateVector D = balance(cycle);
  cycle[0] = scaled(cycle[0], D);
  SteadyState state;
  solve_balanced(cycle, D, {&state, 1});
  return state;
}

void solve_cycle(std::span<const CycleStep> cycle, std::span<SteadyState> states) {
  require_sizes(cycle);
  if (states.size() != cycle.size()) std::abort();
  const StateVector D = balance(cycle);
  std::vector<CycleStep> balanced;
  balanced.reserve(cycle.size());
  for (const CycleStep& step : cycle) balanced.push_back(scaled(step, D));
  solve_balanced(balanced, D, states);
}

}  // namespace delos
