#include "delos/optimize/answers.h"

#include <algorithm>
#include <cmath>

namespace delos {
namespace {

/// Width of edges for slopes, radians.
constexpr double kWidth = 0.03;
/// Halvings of a range: within 1/1000 of what a variable may change.
constexpr int kHalvings = 10;

/// How far variable v may go towards `end` before `kept` fails for the first time, as
/// far as steps of a twentieth and halving tell.
template <class Kept>
double reach(std::vector<double> x, std::size_t v, double end, Kept&& kept) {
  const double start = x[v];
  double good = start, bad = start;
  constexpr int kSteps = 20;
  for (int i = 1; i <= kSteps; ++i) {
    bad = start + (end - start) * i / kSteps;
    x[v] = bad;
    if (!kept(x)) break;
    good = bad;
  }
  for (int i = 0; i < kHalvings && good != bad; ++i) {
    x[v] = good + (bad - good) / 2;
    (kept(x) ? good : bad) = x[v];
  }
  return good;
}

}  // namespace

Answers answers(Problem& problem, std::span<const double> at, double loss,
                const std::atomic<bool>* cancel, const AnswerProgress& progress) {
  const std::vector<double> x(at.begin(), at.end());
  const Score best = problem.score(x);
  const double most = best.objective + loss * std::abs(best.objective);
  const auto stopped = [&] { return cancel && cancel->load(); };
  // What was missed before may be missed as much.
  const auto kept = [&](const std::vector<double>& y) {
    if (stopped()) return false;
    const Score score = problem.score(y);
    for (std::size_t i = 0; i < score.slacks.size(); ++i)
      if (score.slacks[i] < std::min(0.0, best.slacks[i])) return false;
    return score.objective <= most;
  };
  Answers all;
  all.loss = loss;
  const Design& design = problem.design();
  std::vector<double> slope(x.size()), slopes(x.size() * problem.limits().size());
  if (problem.slope_problem().empty())
    (void)problem.score_with_slopes(x, kWidth, slope.data(), slopes.data());
  const auto& devices = design.scene().devices;
  const std::size_t steps = x.size() + devices.size();
  for (std::size_t v = 0; v < x.size() && !stopped(); ++v) {
    if (progress) progress(v, steps);
    VariableAnswer one;
    one.path = design.scene().variables[v].path;
    constexpr double kStep = 1e-6;
    const double unit =
        (design.value(v, x[v] + kStep) - design.value(v, x[v] - kStep)) / (2 * kStep);
    one.slope = slope[v] / unit;
    const double low = reach(x, v, 0, kept), high = reach(x, v, 1, kept);
    one.down = design.value(v, x[v]) - design.value(v, low);
    one.up = design.value(v, high) - design.value(v, x[v]);
    one.down_is_bound = low == 0;
    one.up_is_bound = high == 1;
    all.variables.push_back(std::move(one));
  }
  // Of an objective that withstands failures, the loss is that of what it is without.
  const double plain = problem.plain_objective(x);
  for (std::size_t i = 0; devices.size() > 1 && i < devices.size() && !stopped(); ++i) {
    if (progress) progress(x.size() + i, steps);
    const double without = problem.objective_without(x, i);
    all.devices.push_back({devices[i].name, (without - plain) / std::abs(plain)});
  }
  std::stable_sort(all.devices.begin(), all.devices.end(),
                   [](const DeviceAnswer& a, const DeviceAnswer& b) {
                     return a.without > b.without;
                   });
  return all;
}

}  // namespace delos
