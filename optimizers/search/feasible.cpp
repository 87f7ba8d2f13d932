#include "search/feasible.h"

#include <algorithm>
#include <set>

#include "nlopt/solver.h"

namespace delos {
namespace {

constexpr double kStep = 1e-6;
/// Limits are kept with this room, in units of their scale, so that they hold strictly.
constexpr double kRoom = 1e-5;

std::vector<std::string> violated(Problem& problem, const std::vector<double>& x) {
  std::set<std::size_t> which;
  const std::vector<double> slacks = problem.place_slacks(x);
  for (std::size_t i = 0; i < slacks.size(); ++i)
    if (!(slacks[i] >= 0)) which.insert(problem.limits()[i].constraint);
  std::vector<std::string> names;
  for (const std::size_t c : which)
    names.push_back(problem.design().scene().constraints[c].name);
  return names;
}

void place_slopes(Problem& problem, std::span<const double> x, double* slopes) {
  std::vector<double> at(x.begin(), x.end());
  for (std::size_t v = 0; v < x.size(); ++v) {
    at[v] = x[v] + kStep;
    const std::vector<double> up = problem.place_slacks(at);
    at[v] = x[v] - kStep;
    const std::vector<double> down = problem.place_slacks(at);
    at[v] = x[v];
    for (std::size_t i = 0; i < up.size(); ++i)
      slopes[i * x.size() + v] =
          -(up[i] - down[i]) / (2 * kStep) / problem.limits()[i].scale;
  }
}

}  // namespace

Repair repair(Problem& problem, std::vector<double> start) {
  Repair out{start, false, false, violated(problem, start)};
  out.feasible = out.violated.empty();
  if (out.feasible) return out;

  // min ‖x − start‖² subject to the limits.
  BoxProblem projection;
  projection.limits = problem.place_slacks(start).size();
  projection.evaluate = [&](std::span<const double> x, double* g, double* slope,
                            double* g_slopes) {
    double square = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
      const double d = x[v] - start[v];
      square += d * d;
      if (slope) slope[v] = 2 * d;
    }
    const std::vector<double> slacks = problem.place_slacks(x);
    for (std::size_t i = 0; i < slacks.size(); ++i)
      g[i] = kRoom - slacks[i] / problem.limits()[i].scale;
    if (g_slopes) place_slopes(problem, x, g_slopes);
    return square;
  };
  SolverOptions options;
  options.evaluations = 200;
  // Where constraints have a kink, a start beside it may have what the first hasn't.
  for (int attempt = 0; attempt < 3 && !out.feasible; ++attempt) {
    std::vector<double> x = start;
    for (std::size_t v = 0; v < x.size(); ++v) {
      const double push = 0.1 * attempt * ((v * 7 + 3) % 5 / 2.0 - 1);
      x[v] = std::clamp(x[v] + push, 0.0, 1.0);
    }
    minimize(attempt == 2 ? "cobyla" : "slsqp", projection, options, x);
    for (double& value : x) value = std::clamp(value, 0.0, 1.0);
    const std::vector<std::string> left = violated(problem, x);
    if (!left.empty()) {
      if (attempt == 2) out.violated = left;
      continue;
    }
    out.x = x;
    out.feasible = out.moved = true;
  }
  return out;
}

}  // namespace delos
