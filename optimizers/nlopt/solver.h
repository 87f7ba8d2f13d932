// NLopt, with what it would lose kept outside of it.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace delos {

/// A minimisation over the unit cube, with limits g ≤ 0.
struct BoxProblem {
  std::size_t limits = 0;
  /// Objective at x and all limits; slopes where they aren't null: n numbers, and
  /// limits × n. Not finite: there is nothing at x.
  std::function<double(std::span<const double> x, double* g, double* slope,
                       double* g_slopes)>
      evaluate;
};

/// How NLopt is run.
struct SolverOptions {
  int evaluations = 1000;
  double tolerance = 1e-8;  ///< relative, of x and the objective
  double first_step = 0.1;  ///< of methods without slopes, in the unit cube
  std::uint64_t seed = 1;
  const std::atomic<bool>* cancel = nullptr;
};

/// Why a solver ended.
enum class SolverStop { converged, budget, cancelled, failed };

/// What NLopt can be asked for.
struct SolverTraits {
  bool slopes = false;  ///< reads slopes
  bool limits = false;  ///< keeps limits by itself
  bool global = false;
};

/// The names of methods, as --algorithm takes them: slsqp, mma, ….
[[nodiscard]] std::vector<std::string> solver_names();
[[nodiscard]] SolverTraits solver_traits(const std::string& name);

/// Minimise. Methods that can't keep limits are wrapped in an augmented Lagrangian.
/// @param x the start; on return where NLopt ended, which needn't be the best point:
///          the caller keeps that
/// @throws what `evaluate` threw first
SolverStop minimize(const std::string& name, const BoxProblem& problem,
                    const SolverOptions& options, std::vector<double>& x);

}  // namespace delos
