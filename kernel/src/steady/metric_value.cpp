#include "steady/metric_value.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "delos/model/infinity.h"
#include "steady/largest_eigenvalue.h"

namespace delos {
namespace {

/// First row of the metric's 3×3 block within the pose.
int block_start(MetricKind kind, const StateLayout& layout) {
  return kind == MetricKind::sigma_orientation ? layout.positions() : 0;
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

void pose_metrics(const Metric& metric, const StateLayout& layout, const double* P,
                  double* values) {
  const auto row = [P](int i, int j) { return P + packed_index(i, j) * kLanes; };
  if (metric.kind == MetricKind::sigma) {
    const double* variance = row(metric.state, metric.state);
    for (int l = 0; l < kLanes; ++l) values[l] = std::sqrt(variance[l]);
    return;
  }
  const int s = block_start(metric.kind, layout);
  const double* block[6] = {row(s, s),     row(s + 1, s),     row(s + 1, s + 1),
                            row(s + 2, s), row(s + 2, s + 1), row(s + 2, s + 2)};
  if (metric.kind == MetricKind::eigmax) {
    largest_eigenvalues(block, values);
    for (int l = 0; l < kLanes; ++l) values[l] = std::sqrt(values[l]);
    return;
  }
  for (int l = 0; l < kLanes; ++l) {
    Eigen::Matrix3d at;
    at << block[0][l], block[1][l], block[3][l],  //
        block[1][l], block[2][l], block[4][l],    //
        block[3][l], block[4][l], block[5][l];
    values[l] = block_metric(metric.kind, at);
  }
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
