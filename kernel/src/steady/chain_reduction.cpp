#include "steady/chain_reduction.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

#include "delos/model/infinity.h"
#include "riccati/linear.h"

namespace delos {

bool is_reducible(const System& system) {
  return system.motion.is_chain() &&
         information_size(system) == system.motion.layout.coordinates() &&
         has_one_exposure(system) &&
         (system.fusion == Fusion::stacked || system.fusion == Fusion::continuous);
}

ChainReduction::ChainReduction(const System& system)
    : L(std::get<ChainMotion>(system.motion.dynamics).q.llt().matrixL()),
      order(system.motion.layout.order),
      sampling{system.fusion == Fusion::continuous, system.devices.front().period,
               system.devices.front().exposure, system.exposures, system.lag},
      kind(system.covariance) {}

SpectralForm ChainReduction::form_of(const SteadyEquation& at) const {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto [first, d] = at.block;
  const Measurement& m = at.steps.front().measurement;
  SpectralForm form = spectral_form(L, m.information.block(first, first, d, d));
  if (!form.lacks_digits() || at.readings.empty()) return form;
  const std::vector<double>& all = at.readings.front();
  const Eigen::Index n = m.information.rows(),
                     count = static_cast<Eigen::Index>(all.size()) / n,
                     guesses = at.besides > 0 ? d : 0;
  if (count + guesses < d) return form;  // lost, whatever the digits
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(count + guesses, d);
  rows.topRows(count) =
      Eigen::Map<const Rows>(all.data(), count, n).middleCols(first, d);
  rows.bottomRows(guesses).diagonal().setConstant(std::sqrt(at.besides));
  return spectral_form_of_rows(L, rows);
}

void ChainReduction::solve(const SpectralForm& form, const SteadyRequest& request,
                           FusedState& out) const {
  const auto covariance = [&](CovarianceKind of, StateMatrix& P) {
    if (request.whole_state)
      P = spectral_covariance(form, order, sampling, of);
    else
      P = spectral_pose_covariance(form, order, sampling, of);
  };
  if (request.prior) covariance(CovarianceKind::prior, out.prior);
  if (request.posterior) covariance(CovarianceKind::posterior, out.posterior);

  out.of = sampling.continuous ? CovarianceOf::all_times : CovarianceOf::every_update;
  // A lost direction of the pose is lost with all its derivatives.
  const int lost = form.unobservable, d = static_cast<int>(L.rows());
  out.status = lost ? RiccatiStatus::unobservable : RiccatiStatus::converged;
  out.unobservable.setZero(d * order, lost * order);
  if (lost > 0) {
    const StateMatrix basis = riccati::orthonormal(form.LU.leftCols(lost));
    for (int k = 0; k < order; ++k)
      out.unobservable.block(d * k, lost * k, d, lost) = basis;
  }
  if (!request.time_constant) return;
  // The least measured direction forgets most slowly.
  out.time_constant =
      lost > 0 ? kInfinity
      : sampling.continuous
          ? continuous_chain_time_constant(order, form.lambda(0))
          : exposed_chain_time_constant(order, sampling.dt, sampling.exposure,
                                        form.lambda(0), sampling.model);
}

StateMatrix ChainReduction::adjoint(const SpectralForm& form,
                                    const StateMatrix& Y) const {
  const Eigen::Index n = L.rows() * order;
  StateMatrix whole = StateMatrix::Zero(n, n);
  whole.topLeftCorner(Y.rows(), Y.cols()) = Y;
  return spectral_gradient(form, order, sampling, kind, whole);
}

void ChainReduction::pose_covariances(const LayerBlock& block, double* P,
                                      int* lost) const {
  spectral_pose_covariances(L, order, sampling, kind, block.total.data(), P, lost);
}

}  // namespace delos
