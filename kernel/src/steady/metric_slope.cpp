#include "steady/metric_slope.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "delos/model/infinity.h"
#include "delos/steady/metric_slopes.h"
#include "riccati/jacobi.h"
#include "steady/metric_value.h"

namespace delos {
namespace {

bool reducible(const System& system) {
  return system.motion.is_chain() &&
         information_size(system) == system.motion.layout.coordinates();
}

/// Value of a metric of P, and ∂value/∂P added to Y with a weight; Y may be null.
double of_block(MetricKind kind, const Eigen::Matrix3d& P, double weight,
                Eigen::Matrix3d* Y) {
  switch (kind) {
    case MetricKind::sigma_position:
    case MetricKind::sigma_orientation: {
      const double value = std::sqrt(P.trace());
      if (Y) Y->diagonal().array() += weight / (2 * value);
      return value;
    }
    case MetricKind::trace:
      if (Y) Y->diagonal().array() += weight;
      return P.trace();
    case MetricKind::det: {
      const double value = P.determinant();
      if (Y) *Y += weight * value * P.inverse();
      return value;
    }
    case MetricKind::eiglen: {
      const double norm = P.norm(), value = std::sqrt(norm);
      if (Y) *Y += weight / (2 * value * norm) * P;
      return value;
    }
    case MetricKind::eigmax: {
      // m = (Σ λ^p)^(1/2p);  ∂m/∂P = m/2 · Σ λ^(p−1) u uᵀ / Σ λ^p
      const auto eigen = riccati::jacobi_eigen<3>(P);
      const double largest = eigen.lambda(2);
      const Eigen::Array3d ratio = (eigen.lambda.array() / largest).max(0.0);
      const double sum = ratio.pow(kEigenPower).sum();
      const double value = std::sqrt(largest * std::pow(sum, 1 / kEigenPower));
      if (Y) {
        const Eigen::Vector3d shares =
            weight * value / (2 * largest * sum) * ratio.pow(kEigenPower - 1);
        *Y += eigen.U * shares.asDiagonal() * eigen.U.transpose();
      }
      return value;
    }
    default:
      return kInfinity;
  }
}

double of_state(const Metric& metric, const StateLayout& layout, const StateMatrix& P,
                double weight, StateMatrix* Y) {
  if (metric.kind == MetricKind::sigma) {
    const int i = metric.state;
    const double value = std::sqrt(P(i, i));
    if (Y) (*Y)(i, i) += weight / (2 * value);
    return value;
  }
  if (metric.kind == MetricKind::mle) {
    // m = (2π)^(−n/2) |P|^(−1/2);  ∂m/∂P = −m/2 P⁻¹
    const Eigen::LDLT<StateMatrix> ldlt(P);
    const double n = static_cast<double>(P.rows());
    const double log_det = ldlt.vectorD().array().abs().log().sum();
    const double value =
        std::exp(-0.5 * (n * std::log(2 * std::numbers::pi) + log_det));
    if (Y) *Y -= weight * value / 2 * StateMatrix(P.inverse());
    return value;
  }
  const int start =
      metric.kind == MetricKind::sigma_orientation ? layout.positions() : 0;
  if (!Y) return of_block(metric.kind, P.block<3, 3>(start, start), weight, nullptr);
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
  const double value =
      of_block(metric.kind, P.block<3, 3>(start, start), weight, &block);
  Y->block<3, 3>(start, start) += block;
  return value;
}

}  // namespace

std::string slope_problem(const System& system, const Metric& metric) {
  if (metric.kind == MetricKind::coverage || metric.kind == MetricKind::latency)
    return metric.name + " has no derivative here";
  const bool closed_form = reducible(system) && (system.fusion == Fusion::stacked ||
                                                 system.fusion == Fusion::continuous);
  if (!closed_form && system.fusion != Fusion::stacked)
    return std::string(to_string(system.fusion)) +
           " fusion of this system has no derivative here";
  return "";
}

MetricSlope::MetricSlope(const System& system, const std::vector<Metric>& metrics)
    : metrics_(metrics),
      layout_(system.motion.layout),
      kind_(system.covariance),
      spectral_(reducible(system)),
      whole_state_(std::any_of(metrics.begin(), metrics.end(), [&](const Metric& m) {
        return need_of(m, layout_) != MetricNeed::pose_block;
      })) {
  const double period = system.devices.front().period;
  sampling_ = {system.fusion == Fusion::continuous, period};
  if (spectral_) {
    L_ = std::get<ChainMotion>(system.motion.dynamics).q.llt().matrixL();
  } else {
    step_ = discretize(system.motion, period);
  }
}

bool MetricSlope::solve(const StateMatrix& S, SpectralForm& form, SteadyState& state,
                        StateMatrix& P) const {
  if (spectral_) {
    form = spectral_form(L_, S);
    if (form.unobservable > 0) return false;
    P = whole_state_ ? spectral_covariance(form, layout_.order, sampling_, kind_)
                     : StateMatrix(spectral_pose_covariance(form, layout_.order,
                                                            sampling_, kind_));
    return true;
  }
  const Eigen::Index n = layout_.size();
  Measurement m{StateMatrix::Zero(n, n), StateMatrix(0, n)};
  m.information.topLeftCorner(S.rows(), S.cols()) = S;
  state = solve_doubling(step_, m);
  if (state.status != RiccatiStatus::converged) return false;
  P = kind_ == CovarianceKind::prior ? state.prior : state.posterior;
  return true;
}

void MetricSlope::values(const StateMatrix& S, double* values) const {
  SpectralForm form;
  SteadyState state;
  StateMatrix P;
  const bool finite = solve(S, form, state, P);
  for (std::size_t m = 0; m < metrics_.size(); ++m) {
    values[m] = finite ? of_state(metrics_[m], layout_, P, 0, nullptr) : kInfinity;
    if (!std::isfinite(values[m])) values[m] = kInfinity;
  }
}

void MetricSlope::slope(const StateMatrix& S, const double* weights,
                        StateMatrix& G) const {
  SpectralForm form;
  SteadyState state;
  StateMatrix P;
  G.setZero(S.rows(), S.cols());
  if (!solve(S, form, state, P)) return;
  StateMatrix Y = StateMatrix::Zero(P.rows(), P.cols());
  for (std::size_t m = 0; m < metrics_.size(); ++m) {
    if (weights[m] != 0) of_state(metrics_[m], layout_, P, weights[m], &Y);
  }
  if (!spectral_) {
    const Eigen::Index n = layout_.size();
    Measurement measurement{StateMatrix::Zero(n, n), StateMatrix(0, n)};
    measurement.information.topLeftCorner(S.rows(), S.cols()) = S;
    G = riccati_gradient(step_, measurement, state, Y,
                         kind_ == CovarianceKind::posterior)
            .topLeftCorner(S.rows(), S.cols());
    return;
  }
  const Eigen::Index n = layout_.coordinates() * layout_.order;
  StateMatrix whole = StateMatrix::Zero(n, n);
  whole.topLeftCorner(Y.rows(), Y.cols()) = Y;
  G = spectral_gradient(form, layout_.order, sampling_, kind_, whole);
}

}  // namespace delos
