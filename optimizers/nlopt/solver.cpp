#include "nlopt/solver.h"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

namespace delos {
namespace {

struct Named {
  const char* name;
  nlopt_algorithm algorithm;
  SolverTraits traits;
};

constexpr Named kSolvers[] = {
    {"slsqp", NLOPT_LD_SLSQP, {true, true, false}},
    {"mma", NLOPT_LD_MMA, {true, true, false}},
    {"ccsa", NLOPT_LD_CCSAQ, {true, true, false}},
    {"lbfgs", NLOPT_LD_LBFGS, {true, false, false}},
    {"cobyla", NLOPT_LN_COBYLA, {false, true, false}},
    {"bobyqa", NLOPT_LN_BOBYQA, {false, false, false}},
    {"sbplx", NLOPT_LN_SBPLX, {false, false, false}},
    {"direct", NLOPT_GN_DIRECT_L, {false, false, true}},
    {"crs2", NLOPT_GN_CRS2_LM, {false, false, true}},
    {"isres", NLOPT_GN_ISRES, {false, true, true}},
    {"stogo", NLOPT_GD_STOGO, {true, false, true}},
    {"mlsl", NLOPT_G_MLSL_LDS, {true, false, true}},
};

const Named& named(const std::string& name) {
  return *std::find_if(std::begin(kSolvers), std::end(kSolvers),
                       [&](const Named& s) { return name == s.name; });
}

/// What NLopt's callbacks share: one evaluation serves objective and limits.
struct Run {
  const BoxProblem& problem;
  const SolverOptions& options;
  std::size_t n;
  nlopt_opt opt;
  std::vector<double> x, g, slope, g_slopes;
  double value = 0;
  bool with_slopes = false;
  int evaluations = 0;
  std::exception_ptr failure;

  /// NLopt asks for objective and limits one after the other, at the same point.
  void at(const double* point, bool slopes) {
    const bool known = x.size() == n && std::equal(x.begin(), x.end(), point) &&
                       (with_slopes || !slopes);
    if (known || failure) return;
    x.assign(point, point + n);
    with_slopes = slopes;
    slope.resize(n);
    g.assign(problem.limits, 0);
    g_slopes.resize(problem.limits * n);
    const bool stop = (options.cancel && options.cancel->load()) ||
                      ++evaluations > options.evaluations;
    if (stop) {
      nlopt_force_stop(opt);
      return;
    }
    try {
      value = problem.evaluate(x, g.data(), slopes ? slope.data() : nullptr,
                               slopes ? g_slopes.data() : nullptr);
    } catch (...) {
      failure = std::current_exception();
      nlopt_force_stop(opt);
    }
    // Where there is nothing: worse than anything, and no way to tell where to go.
    if (!std::isfinite(value)) {
      value = 1e30;
      std::fill(slope.begin(), slope.end(), 0.0);
      std::fill(g.begin(), g.end(), 1e30);
      std::fill(g_slopes.begin(), g_slopes.end(), 0.0);
    }
  }
};

double objective(unsigned, const double* x, double* gradient, void* data) {
  Run& run = *static_cast<Run*>(data);
  run.at(x, gradient != nullptr);
  if (gradient) std::copy(run.slope.begin(), run.slope.end(), gradient);
  return run.value;
}

void limits(unsigned, double* result, unsigned, const double* x, double* gradient,
            void* data) {
  Run& run = *static_cast<Run*>(data);
  run.at(x, gradient != nullptr);
  std::copy(run.g.begin(), run.g.end(), result);
  if (gradient) std::copy(run.g_slopes.begin(), run.g_slopes.end(), gradient);
}

using Optimizer = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

Optimizer make(nlopt_algorithm algorithm, std::size_t n, double tolerance) {
  Optimizer opt(nlopt_create(algorithm, static_cast<unsigned>(n)), &nlopt_destroy);
  nlopt_set_lower_bounds1(opt.get(), 0);
  nlopt_set_upper_bounds1(opt.get(), 1);
  nlopt_set_ftol_rel(opt.get(), tolerance);
  nlopt_set_xtol_abs1(opt.get(), tolerance);
  return opt;
}

}  // namespace

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const Named& s : kSolvers) names.emplace_back(s.name);
  return names;
}

SolverTraits solver_traits(const std::string& name) { return named(name).traits; }

SolverStop minimize(const std::string& name, const BoxProblem& problem,
                    const SolverOptions& options, std::vector<double>& x) {
  const Named& solver = named(name);
  const bool wrapped = problem.limits > 0 && !solver.traits.limits;
  const std::size_t n = x.size();
  Optimizer inner = make(solver.algorithm, n, options.tolerance);
  // MLSL starts local searches, which are better done by a quick method.
  Optimizer local = make(NLOPT_LD_LBFGS, n, 1e-4);
  if (name == "mlsl") nlopt_set_local_optimizer(inner.get(), local.get());
  Optimizer outer = make(NLOPT_AUGLAG, n, options.tolerance);
  nlopt_opt opt = inner.get();
  if (wrapped) {
    nlopt_set_local_optimizer(outer.get(), inner.get());
    opt = outer.get();
  }
  if (!solver.traits.slopes) nlopt_set_initial_step1(opt, options.first_step);
  nlopt_srand(static_cast<unsigned long>(options.seed));

  Run run{problem, options, n, opt, {}, {}, {}, {}};
  nlopt_set_min_objective(opt, objective, &run);
  if (problem.limits > 0) {
    const std::vector<double> tolerance(problem.limits, 1e-9);
    nlopt_add_inequality_mconstraint(opt, static_cast<unsigned>(problem.limits), limits,
                                     &run, tolerance.data());
  }
  double value = 0;
  const nlopt_result result = nlopt_optimize(opt, x.data(), &value);
  if (run.failure) std::rethrow_exception(run.failure);
  if (options.cancel && options.cancel->load()) return SolverStop::cancelled;
  if (run.evaluations > options.evaluations) return SolverStop::budget;
  return result > 0 || result == NLOPT_ROUNDOFF_LIMITED ? SolverStop::converged
                                                        : SolverStop::failed;
}

}  // namespace delos
