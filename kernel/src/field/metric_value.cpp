#include "field/metric_value.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "riccati/jacobi.h"

namespace delos {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// First row of the metric's 3×3 block within the pose.
int block_start(MetricKind kind, const StateLayout& layout) {
  return kind == MetricKind::sigma_orientation ? layout.positions() : 0;
}

/// Largest eigenvalue of a symmetric 3×3 matrix ≥ 0, from its characteristic
/// polynomial:
///
///     λmax = m + 2 √p cos(φ/3),  m = tr P/3,  p = ‖P − m I‖²/6,  cos φ = det(P − m
///     I)/(2 p^(3/2))
///
/// A sum of two terms ≥ 0. φ loses digits as cos φ → −1, where the two largest
/// eigenvalues meet: Jacobi rotations take over there. Source: Smith (1961), Commun.
/// ACM 4(4), 168, doi:10.1145/355578.366316.
double largest_eigenvalue(const Eigen::Matrix3d& P) {
  const double m = P.trace() / 3;
  Eigen::Matrix3d rest = P;
  rest.diagonal().array() -= m;
  const double p = rest.squaredNorm() / 6;
  if (!(p > 0)) return m;
  const double cosine = rest.determinant() / (2 * p * std::sqrt(p));
  if (cosine < -0.999999) return riccati::jacobi_eigen<3>(P).lambda(2);
  return m + 2 * std::sqrt(p) * std::cos(std::acos(std::min(cosine, 1.0)) / 3);
}

double block_metric(MetricKind kind, const Eigen::Matrix3d& P) {
  switch (kind) {
    case MetricKind::sigma_position:
    case MetricKind::sigma_orientation:
      return std::sqrt(P.trace());
    case MetricKind::trace:
      return P.trace();
    case MetricKind::det:
      return P.determinant();
    case MetricKind::eiglen:
      // Σ λᵢ² is the squared Frobenius norm.
      return std::sqrt(P.norm());
    case MetricKind::eigmax:
      return std::sqrt(largest_eigenvalue(P));
    default:
      return kInfinity;
  }
}

/// True where the states [first, first + count) avoid every lost direction.
bool observed(const StateMatrix& unobservable, int first, int count) {
  return unobservable.cols() == 0 ||
         unobservable.middleRows(first, count).cwiseAbs().maxCoeff() < 1e-9;
}

/// (2π)^(−n/2) |P|^(−1/2), through logarithms: |P| of nine states underflows easily.
double likelihood(const StateMatrix& P) {
  const Eigen::LDLT<StateMatrix> ldlt(P);
  const double log_det = ldlt.vectorD().array().abs().log().sum();
  const double n = static_cast<double>(P.rows());
  return std::exp(-0.5 * (n * std::log(2 * std::numbers::pi) + log_det));
}

}  // namespace

MetricNeed need_of(const Metric& metric, const StateLayout& layout) {
  switch (metric.kind) {
    case MetricKind::coverage:
      return MetricNeed::nothing;
    case MetricKind::mle:
      return MetricNeed::whole_state;
    case MetricKind::latency:
      return MetricNeed::time_constant;
    case MetricKind::sigma:
      return metric.state < layout.coordinates() ? MetricNeed::pose_block
                                                 : MetricNeed::whole_state;
    default:
      return MetricNeed::pose_block;
  }
}

double pose_metric(const Metric& metric, const StateLayout& layout,
                   const CoordinateMatrix& P) {
  if (metric.kind == MetricKind::sigma) return std::sqrt(P(metric.state, metric.state));
  const int start = block_start(metric.kind, layout);
  return block_metric(metric.kind, P.block<3, 3>(start, start));
}

double state_metric(const Metric& metric, const StateLayout& layout,
                    const FusedState& state, CovarianceKind kind) {
  if (state.status == RiccatiStatus::iteration_limit) return kInfinity;
  const StateMatrix& P = kind == CovarianceKind::prior ? state.prior : state.posterior;
  if (metric.kind == MetricKind::latency) return state.time_constant;
  if (metric.kind == MetricKind::mle) {
    // An unbounded covariance has a density of zero, which says nothing of the rest.
    return state.unobservable.cols() > 0 ? kInfinity : likelihood(P);
  }
  if (metric.kind == MetricKind::sigma) {
    return observed(state.unobservable, metric.state, 1)
               ? std::sqrt(P(metric.state, metric.state))
               : kInfinity;
  }
  const int start = block_start(metric.kind, layout);
  return observed(state.unobservable, start, 3)
             ? block_metric(metric.kind, P.block<3, 3>(start, start))
             : kInfinity;
}

}  // namespace delos
