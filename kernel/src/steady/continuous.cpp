#include "steady/continuous.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "delos/model/infinity.h"
#include "riccati/linear.h"
#include "steady/chain_reduction.h"
#include "steady/general_state.h"

namespace delos {
namespace {

// With W = null(E L), and M = (L W)ᵀ S (L W) = U Λ Uᵀ: the directions L W U of what
// perfect rows E leave, first, and the pinned ones, with λ = ∞ and so no variance.
SpectralForm pinned_form(const CoordinateMatrix& L, const StateMatrix& E,
                         const CoordinateMatrix& S) {
  const Eigen::Index d = L.rows();
  const StateMatrix EL = E * L;
  const StateMatrix W = riccati::null_space(EL, 1e-12 * EL.norm());
  const Eigen::Index rest = W.cols();
  SpectralForm form;
  form.LU.setZero(d, d);
  form.lambda = CoordinateVector::Constant(d, kInfinity);
  if (rest == 0) return form;
  const CoordinateMatrix LW = L * W;
  const CoordinateMatrix M = LW.transpose() * S * LW;
  const SpectralForm inner = spectral_form(CoordinateMatrix::Identity(rest, rest), M);
  form.lambda.head(rest) = inner.lambda;
  form.LU.leftCols(rest) = LW * inner.LU;
  form.unobservable = inner.unobservable;
  return form;
}

}  // namespace

ContinuousSolver::ContinuousSolver(const System& system, Solver solver)
    : SmoothSteadySolver(system, solver) {
  add_step(continuous_form(system.motion), all_devices(system.devices.size()));
}

void ContinuousSolver::find(SteadyEquation& at, const SteadyRequest& request,
                            FusedState& out) const {
  out.of = CovarianceOf::all_times;
  const auto& [motion, measurement] = at.steps.front();
  if (measurement.exact.rows() > 0) return solve_pinned(at, request, out);
  SteadyState& state = at.states.front();
  state = solve_continuous(motion, measurement);
  const auto slowest = [&] {
    return -1 / std::min(-0.0,
                         continuous_closed_loop_rate(motion, measurement, state.prior));
  };
  // A rounding of S works on for as long as the filter remembers.
  const bool lack =
      state.status != RiccatiStatus::converged ||
      !(weight_of_information(measurement.information, state.prior) * slowest() <
        kMostWeight);
  if (lack && at.take_readings({at.block.first, system_.motion.layout.coordinates()}))
    state = solve_continuous(motion, measurement);
  set_state(state, out);
  if (request.time_constant) out.time_constant = slowest();
}

// Rows E that are measured continuously and without noise pin their directions and all
// derivatives of them, f(∞) = 0. What is left is the system compressed to the
// directions that they don't see:
//
//     P∞ = L W f(Wᵀ Lᵀ S L W) Wᵀ Lᵀ
void ContinuousSolver::solve_pinned(SteadyEquation& at, const SteadyRequest& request,
                                    FusedState& out) const {
  const Eigen::Index d = system_.motion.layout.coordinates();
  if (!is_reducible(system_)) {
    // Perfect rows over derivatives have no such limit; periodic fusion solves them.
    const Eigen::Index n = system_.motion.layout.size();
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    out.status = RiccatiStatus::iteration_limit;
    out.prior = out.posterior = StateMatrix::Constant(n, n, kNothing);
    out.unobservable.resize(n, 0);
    out.time_constant = kNothing;
    return;
  }
  const Measurement& m = at.steps.front().measurement;
  System at_update = system_;
  at_update.lag = 0;  // in which what is pinned moves, too: solve() sees to it
  const ChainReduction reduction(at_update);
  at.form =
      pinned_form(reduction.L, m.exact.leftCols(d), m.information.topLeftCorner(d, d));
  reduction.solve(*at.form, request, out);
}

StateMatrix ContinuousSolver::find_adjoint(const SteadyEquation& at,
                                           const StateMatrix& Y) const {
  // What is pinned doesn't move: its columns of L U are zero, whatever its λ.
  SpectralForm form = *at.form;
  for (double& lambda : form.lambda)
    if (std::isinf(lambda)) lambda = 1;
  return reduction()->adjoint(form, Y);
}

}  // namespace delos
