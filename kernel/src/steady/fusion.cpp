#include "delos/steady/fusion.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "delos/riccati/cycle.h"
#include "observe/exact_rows.h"
#include "observe/measure.h"
#include "riccati/linear.h"

namespace delos {
namespace {

bool cyclic(Fusion fusion) {
  return fusion == Fusion::periodic || fusion == Fusion::sequential;
}

/// The solver that fits, or the reason why the forced one doesn't.
Solver choose(const System& system, Solver wanted) {
  const bool reducible =
      system.motion.is_chain() &&
      information_size(system) == system.motion.layout.coordinates() &&
      (system.fusion == Fusion::stacked || system.fusion == Fusion::continuous);
  const std::string fusion = to_string(system.fusion);
  switch (wanted) {
    case Solver::automatic:
      if (system.fusion == Fusion::artemis) return Solver::eigenvector;
      return reducible ? Solver::spectral : Solver::doubling;
    case Solver::spectral:
      if (!reducible) {
        throw std::invalid_argument(
            "--solver spectral needs a position, position_velocity or "
            "position_velocity_acceleration motion, devices that measure the pose "
            "alone, "
            "and stacked or continuous fusion; use --solver doubling");
      }
      break;
    case Solver::doubling:
      if (system.fusion == Fusion::artemis) {
        throw std::invalid_argument(
            "--solver doubling can't do artemis fusion, whose sum of Ψ matrices is no "
            "Riccati equation; use --solver eigenvector");
      }
      break;
    case Solver::eigenvector:
      if (system.fusion != Fusion::artemis && system.fusion != Fusion::stacked) {
        throw std::invalid_argument("--solver eigenvector can't do " + fusion +
                                    " fusion; use --solver doubling");
      }
      break;
  }
  return wanted;
}

bool has_perfect_rows(const LayerBlock& block, int lane) {
  for (const std::uint64_t perfect : block.perfect) {
    if (perfect >> lane & 1) return true;
  }
  return false;
}

/// Lane l of packed columns, as the upper left block of an n×n matrix.
void unpack(const double* packed, int lane, int columns, int n, StateMatrix& S) {
  S.setZero(n, n);
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j <= i; ++j) {
      S(i, j) = S(j, i) = packed[packed_index(i, j) * kLanes + lane];
    }
  }
}

void set_state(const SteadyState& state, FusedState& out) {
  out.status = state.status;
  out.prior = state.prior;
  out.posterior = state.posterior;
  out.unobservable = state.unobservable;
}

double time_constant_of_radius(double radius, double period) {
  if (radius >= 1) return std::numeric_limits<double>::infinity();
  return radius > 0 ? -period / std::log(radius) : 0;
}

}  // namespace

const char* to_string(Solver solver) {
  switch (solver) {
    case Solver::automatic:
      return "auto";
    case Solver::spectral:
      return "spectral";
    case Solver::doubling:
      return "doubling";
    case Solver::eigenvector:
      return "eigenvector";
  }
  return "";
}

FusionSolver::FusionSolver(const System& system, Solver solver)
    : system_(system),
      solver_(choose(system, solver)),
      columns_(information_size(system)) {
  const double period = system.devices.front().period;
  sampling_ = {system.fusion == Fusion::continuous, period};
  if (const auto* chain = std::get_if<ChainMotion>(&system.motion.dynamics)) {
    L_ = chain->q.llt().matrixL();
  }
  if (cyclic(system.fusion)) {
    auto cycle = update_cycle(system);
    if (const auto* problem = std::get_if<std::string>(&cycle)) {
      throw std::invalid_argument(*problem);
    }
    slots_ = std::get<std::vector<UpdateSlot>>(std::move(cycle));
    for (const UpdateSlot& slot : slots_) {
      cycle_.push_back({discretize(system.motion, slot.interval), {}});
      intervals_.push_back(slot.interval);
    }
  } else if (system.fusion == Fusion::artemis) {
    for (const PlacedDevice& d : system.devices) {
      cycle_.push_back({discretize(system.motion, d.period), {}});
    }
  }
  step_ = sampling_.continuous ? continuous_form(system.motion)
                               : discretize(system.motion, period);
}

FusionSolver::Scratch FusionSolver::make_scratch() const {
  Scratch scratch;
  scratch.cycle = cycle_;
  scratch.states.resize(cycle_.size());
  scratch.exact.resize(system_.devices.size());
  scratch.step = step_;
  return scratch;
}

bool FusionSolver::spectral(const LayerBlock& block, int lane) const {
  return solver_ == Solver::spectral && !has_perfect_rows(block, lane);
}

double FusionSolver::residual(const LayerBlock& block, int lane,
                              const FusedState& state) const {
  if (has_perfect_rows(block, lane)) return std::numeric_limits<double>::quiet_NaN();
  Measurement m;
  const int n = system_.motion.layout.size();
  unpack(block.total.data(), lane, columns_, n, m.information);
  m.exact.resize(0, n);
  return riccati_residual(step_, m, state.prior);
}

void FusionSolver::pose_covariances(const LayerBlock& block, CovarianceKind kind,
                                    double* P, int* lost) const {
  spectral_pose_covariances(L_, system_.motion.layout.order, sampling_, kind,
                            block.total.data(), P, lost);
}

void FusionSolver::solve_spectral(const SpectralForm& form, bool with_time_constant,
                                  FusedState& out) const {
  const int order = system_.motion.layout.order;
  const int d = system_.motion.layout.coordinates();
  out.prior = spectral_covariance(form, order, sampling_, CovarianceKind::prior);
  out.posterior =
      spectral_covariance(form, order, sampling_, CovarianceKind::posterior);
  out.status =
      form.unobservable ? RiccatiStatus::unobservable : RiccatiStatus::converged;
  // A lost direction of the pose is lost with all its derivatives.
  const int lost = form.unobservable;
  out.unobservable.setZero(d * order, lost * order);
  if (lost > 0) {
    const StateMatrix basis = riccati::orthonormal(form.LU.leftCols(lost));
    for (int k = 0; k < order; ++k) {
      out.unobservable.block(d * k, lost * k, d, lost) = basis;
    }
  }
  if (!with_time_constant) return;
  // The least measured direction forgets most slowly.
  out.time_constant =
      lost > 0 ? std::numeric_limits<double>::infinity()
      : sampling_.continuous
          ? continuous_chain_time_constant(order, form.lambda(0))
          : discrete_chain_time_constant(order, sampling_.dt, form.lambda(0));
}

void FusionSolver::solve_rows(const Eigen::Ref<const Eigen::MatrixXd>& rows,
                              bool with_time_constant, FusedState& out) const {
  solve_spectral(spectral_form_of_rows(L_, rows), with_time_constant, out);
}

void FusionSolver::solve(const LayerBlock& block, int lane, const TargetPose& pose,
                         bool with_time_constant, Scratch& scratch,
                         FusedState& out) const {
  if (spectral(block, lane)) {
    StateMatrix S;
    unpack(block.total.data(), lane, columns_, columns_, S);
    solve_spectral(spectral_form(L_, S), with_time_constant, out);
    return;
  }
  // Rows without noise have no place in a layer: read them again, for the devices that
  // have them at this pose.
  const int n = system_.motion.layout.size();
  for (std::size_t i = 0; i < system_.devices.size(); ++i) {
    StateMatrix& exact = scratch.exact[i];
    exact.resize(0, n);
    if (!(block.perfect[i] >> lane & 1)) continue;
    MeasureScratch measuring;
    const auto keep = [&](const StateRow& row) {
      if (!row.perfect()) return;
      StateVector whole = StateVector::Zero(n);
      whole.head(columns_) = row.h;
      append_independent(whole, exact);
    };
    measure(system_, system_.devices[i], pose, columns_, measuring, keep);
  }
  solve_general(block, lane, with_time_constant, scratch, out);
}

void FusionSolver::solve_general(const LayerBlock& block, int lane,
                                 bool with_time_constant, Scratch& scratch,
                                 FusedState& out) const {
  const int n = system_.motion.layout.size();
  const std::size_t packed =
      static_cast<std::size_t>(packed_index(columns_, 0)) * kLanes;
  if (!cycle_.empty()) {
    for (std::size_t s = 0; s < cycle_.size(); ++s) {
      Measurement& m = scratch.cycle[s].measurement;
      m.information.setZero(n, n);
      m.information.diagonal()
          .head(system_.motion.layout.coordinates())
          .setConstant(system_.prior);
      m.exact.resize(0, n);
      const auto add = [&](int device) {
        const auto i = static_cast<std::size_t>(device);
        unpack(block.layers.data() + i * packed, lane, columns_, n,
               scratch.measurement.information);
        m.information += scratch.measurement.information;
        for (Eigen::Index r = 0; r < scratch.exact[i].rows(); ++r) {
          append_independent(scratch.exact[i].row(r).transpose(), m.exact);
        }
      };
      if (slots_.empty()) {
        add(static_cast<int>(s));
      } else {
        for (const int device : slots_[s].devices) add(device);
      }
    }
    if (slots_.empty()) {
      set_state(solve_eigenvector(scratch.cycle), out);
      out.time_constant = std::numeric_limits<double>::quiet_NaN();
    } else {
      solve_over_cycle(with_time_constant, scratch, out);
    }
    return;
  }

  Measurement& m = scratch.measurement;
  unpack(block.total.data(), lane, columns_, n, m.information);
  m.exact.resize(0, n);
  for (const StateMatrix& exact : scratch.exact) {
    for (Eigen::Index r = 0; r < exact.rows(); ++r) {
      append_independent(exact.row(r).transpose(), m.exact);
    }
  }
  if (sampling_.continuous) {
    if (m.exact.rows() > 0) {
      solve_continuous_exact(m, with_time_constant, out);
      return;
    }
    set_state(solve_continuous(step_, m.information), out);
    if (with_time_constant) {
      out.time_constant = -1 / std::min(-0.0, continuous_closed_loop_rate(
                                                  step_, m.information, out.prior));
    }
    return;
  }
  if (solver_ == Solver::eigenvector && m.exact.rows() == 0) {
    const CycleStep step{step_, m};
    set_state(solve_eigenvector({&step, 1}), out);
  } else {
    set_state(solve_doubling(step_, m), out);
  }
  if (with_time_constant) {
    const CycleStep step{step_, m};
    const SteadyState state{out.status, out.prior, out.posterior, out.unobservable, 0};
    out.time_constant = time_constant_of_radius(
        closed_loop_radius({&step, 1}, {&state, 1}), sampling_.dt);
  }
}

// Rows E that are measured continuously and without noise pin their directions and all
// derivatives of them, f(∞) = 0. What is left is the system compressed to the
// directions that they don't see: with W = null(E L),
//
//     P∞ = L W f(Wᵀ Lᵀ S L W) Wᵀ Lᵀ
void FusionSolver::solve_continuous_exact(const Measurement& m, bool with_time_constant,
                                          FusedState& out) const {
  const int d = system_.motion.layout.coordinates();
  if (columns_ != d) {
    // Perfect rows over derivatives have no such limit; periodic fusion solves them.
    const int n = system_.motion.layout.size();
    out.status = RiccatiStatus::iteration_limit;
    out.prior = out.posterior =
        StateMatrix::Constant(n, n, std::numeric_limits<double>::quiet_NaN());
    out.unobservable.resize(n, 0);
    out.time_constant = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  const StateMatrix E = m.exact.leftCols(d) * L_;
  const StateMatrix W = riccati::null_space(E, 1e-12 * E.norm());
  const int rest = static_cast<int>(W.cols());

  // Pinned directions stand last, with λ = ∞ and so no variance.
  SpectralForm form;
  form.LU.setZero(d, d);
  form.lambda = CoordinateVector::Constant(d, std::numeric_limits<double>::infinity());
  if (rest > 0) {
    const CoordinateMatrix LW = L_ * W;
    const CoordinateMatrix M = LW.transpose() * m.information.topLeftCorner(d, d) * LW;
    const SpectralForm inner = spectral_form(CoordinateMatrix::Identity(rest, rest), M);
    form.lambda.head(rest) = inner.lambda;
    form.LU.leftCols(rest) = LW * inner.LU;
    form.unobservable = inner.unobservable;
  }
  solve_spectral(form, with_time_constant, out);
}

void FusionSolver::solve_over_cycle(bool with_time_constant, Scratch& scratch,
                                    FusedState& out) const {
  solve_cycle(scratch.cycle, scratch.states);
  const int n = system_.motion.layout.size(), d = system_.motion.layout.coordinates();
  const auto size = [d](const StateMatrix& P) { return P.topLeftCorner(d, d).trace(); };
  out.status = RiccatiStatus::converged;
  out.unobservable = scratch.states.back().unobservable;
  out.prior.setZero(n, n);
  out.posterior.setZero(n, n);
  out.worst_prior = scratch.states.front().prior;
  out.best_posterior = scratch.states.front().posterior;
  for (const SteadyState& state : scratch.states) {
    if (state.status != RiccatiStatus::converged) out.status = state.status;
    if (size(state.prior) > size(out.worst_prior)) out.worst_prior = state.prior;
    if (size(state.posterior) < size(out.best_posterior)) {
      out.best_posterior = state.posterior;
    }
    out.prior += state.prior;
    out.posterior += state.posterior;
  }
  if (system_.fusion == Fusion::periodic) {
    out.prior = time_average(system_.motion, intervals_, scratch.states,
                             AverageRule::trapezoid);
    out.posterior = out.prior;
  } else {
    out.prior /= static_cast<double>(scratch.states.size());
    out.posterior /= static_cast<double>(scratch.states.size());
  }
  if (with_time_constant) {
    const double length = std::accumulate(intervals_.begin(), intervals_.end(), 0.0);
    out.time_constant =
        out.status == RiccatiStatus::converged
            ? time_constant_of_radius(closed_loop_radius(scratch.cycle, scratch.states),
                                      length)
            : std::numeric_limits<double>::infinity();
  }
}

}  // namespace delos
