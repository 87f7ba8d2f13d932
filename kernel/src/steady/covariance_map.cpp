#include "delos/steady/covariance_map.h"

#include <Eigen/Cholesky>

#include "observe/exact_rows.h"

namespace delos {
namespace {

/// Whether pose-level measurements of a chain alone make the information.
bool is_reducible(const System& system) {
  return system.motion.is_chain() &&
         information_size(system) == system.motion.layout.coordinates();
}

}  // namespace

std::string covariance_map_problem(const System& system) {
  const bool closed_form = is_reducible(system) && system.fusion == Fusion::continuous;
  if (closed_form || system.fusion == Fusion::stacked) return "";
  return std::string(to_string(system.fusion)) +
         " fusion of this system has no derivative here";
}

CovarianceMap::CovarianceMap(const System& system, bool whole_state)
    : layout_(system.motion.layout),
      kind_(system.covariance),
      reducible_(is_reducible(system)),
      whole_state_(whole_state),
      sampling_{system.fusion == Fusion::continuous, system.devices.front().period} {
  if (reducible_) L_ = std::get<ChainMotion>(system.motion.dynamics).q.llt().matrixL();
  // Rows without noise need the general solver.
  if (!sampling_.continuous) step_ = discretize(system.motion, sampling_.dt);
}

RiccatiStatus CovarianceMap::solve(const StateMatrix& S, const Eigen::MatrixXd& exact,
                                   Solution& out) const {
  out.spectral = reducible_ && exact.rows() == 0;
  if (out.spectral) {
    out.form = spectral_form(L_, S);
    if (out.form.unobservable > 0) return RiccatiStatus::unobservable;
    out.P = whole_state_
                ? spectral_covariance(out.form, layout_.order, sampling_, kind_)
                : StateMatrix(spectral_pose_covariance(out.form, layout_.order,
                                                       sampling_, kind_));
    return RiccatiStatus::converged;
  }
  const Eigen::Index n = layout_.size();
  out.measurement = {StateMatrix::Zero(n, n), StateMatrix(0, n)};
  out.measurement.information.topLeftCorner(S.rows(), S.cols()) = S;
  for (Eigen::Index r = 0; r < exact.rows(); ++r) {
    StateVector row = StateVector::Zero(n);
    row.head(exact.cols()) = exact.row(r);
    append_independent(row, out.measurement.exact);
  }
  out.state = solve_doubling(step_, out.measurement);
  if (out.state.status != RiccatiStatus::converged) return out.state.status;
  out.P = kind_ == CovarianceKind::prior ? out.state.prior : out.state.posterior;
  if (!whole_state_)
    out.P.conservativeResize(layout_.coordinates(), layout_.coordinates());
  return RiccatiStatus::converged;
}

StateMatrix CovarianceMap::adjoint(const Solution& at, const StateMatrix& Y) const {
  const auto padded = [&](Eigen::Index n) {
    StateMatrix whole = StateMatrix::Zero(n, n);
    whole.topLeftCorner(Y.rows(), Y.cols()) = Y;
    return whole;
  };
  if (at.spectral)
    return spectral_gradient(at.form, layout_.order, sampling_, kind_,
                             padded(layout_.coordinates() * layout_.order));
  return riccati_gradient(step_, at.measurement, at.state, padded(layout_.size()),
                          kind_ == CovarianceKind::posterior);
}

}  // namespace delos
