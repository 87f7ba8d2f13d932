#include "delos/model/metric_table.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "delos/model/lanes.h"
#include "delos/model/metric_expression.h"
#include "model/jacobi.h"
#include "model/largest_eigenvalue.h"

namespace delos {
namespace {

template <int kSize>
using Block = Eigen::Matrix<double, kSize, kSize>;

/// Calls f.template operator()<b>() for the sizes of blocks of a place or a turn.
template <class F>
decltype(auto) with_block(Eigen::Index size, F&& f) {
  switch (size) {
    case 1:
      return f.template operator()<1>();
    case 2:
      return f.template operator()<2>();
    default:
      return f.template operator()<3>();
  }
}

// What one number says of a block, and its slope there.

struct Trace {
  template <int b>
  static double value(const Block<b>& P) {
    return P.trace();
  }
  template <int b>
  static Block<b> slope(const Block<b>&, double) {
    return Block<b>::Identity();
  }
};

struct Determinant {
  template <int b>
  static double value(const Block<b>& P) {
    return P.determinant();
  }
  /// ∂|P|/∂P = |P| P⁻¹
  template <int b>
  static Block<b> slope(const Block<b>& P, double det) {
    return det * P.inverse();
  }
};

/// √Σ λᵢ² is the Frobenius norm.
struct Norm {
  template <int b>
  static double value(const Block<b>& P) {
    return P.norm();
  }
  template <int b>
  static Block<b> slope(const Block<b>& P, double norm) {
    return P / norm;
  }
};

struct Largest {
  template <int b>
  static double value(const Block<b>& P) {
    return largest_eigenvalue(P);
  }
};

template <class Number>
double of_block(const CovarianceBlock& P) {
  return with_block(P.rows(), [&]<int b>() { return Number::value(Block<b>(P)); });
}

template <class Number>
void one_part(const CovarianceBlock& P, bool slopes, MetricParts& out) {
  with_block(P.rows(), [&]<int b>() {
    const Block<b> block = P;
    out.count = 1;
    out.value[0] = Number::value(block);
    if (slopes) out.slope[0] = Number::slope(block, out.value[0]);
  });
}

template <class Number>
void in_lanes(const double* const P[6], int size, double* values) {
  with_block(size, [&]<int b>() {
    for (int l = 0; l < kLanes; ++l) {
      Block<b> at;
      for (int i = 0; i < b; ++i)
        for (int j = 0; j <= i; ++j) at(i, j) = at(j, i) = P[packed_index(i, j)][l];
      values[l] = Number::value(at);
    }
  });
}

void largest_in_lanes(const double* const P[6], int size, double* values) {
  if (size == 3) return largest_eigenvalues(P, values);
  in_lanes<Largest>(P, size, values);
}

/// λᵢ and uᵢ uᵢᵀ.
void eigenvalues(const CovarianceBlock& P, bool slopes, MetricParts& out) {
  with_block(P.rows(), [&]<int b>() {
    const auto eigen = jacobi_eigen<b>(P);
    out.count = b;
    for (int i = 0; i < b; ++i) {
      out.value[i] = eigen.lambda(i);
      if (slopes) out.slope[i] = eigen.U.col(i) * eigen.U.col(i).transpose();
    }
  });
}

double variance(const CovarianceBlock& P) { return P(0, 0); }
void variance_part(const CovarianceBlock& P, bool slopes, MetricParts& out) {
  out.count = 1;
  out.value[0] = P(0, 0);
  if (slopes) out.slope[0].setOnes(1, 1);
}

double horizontal(const CovarianceBlock& P) { return P(0, 0) + P(1, 1); }
void horizontal_part(const CovarianceBlock& P, bool slopes, MetricParts& out) {
  out.count = 1;
  out.value[0] = horizontal(P);
  if (slopes) out.slope[0].setIdentity(2, 2);
}
void horizontals(const double* const P[6], int, double* values) {
  for (int l = 0; l < kLanes; ++l) values[l] = P[0][l] + P[2][l];
}

/// (2π)^(−n/2) |P|^(−1/2), through logarithms: |P| of nine states underflows easily.
double likelihood(const CovarianceBlock& P) {
  const Eigen::LDLT<StateMatrix> ldlt(P);
  const double log_det = ldlt.vectorD().array().abs().log().sum();
  const double n = static_cast<double>(P.rows());
  return std::exp(-0.5 * (n * std::log(2 * std::numbers::pi) + log_det));
}
/// ∂m/∂P = −m/2 P⁻¹
void likelihood_part(const CovarianceBlock& P, bool slopes, MetricParts& out) {
  out.count = 1;
  out.value[0] = likelihood(P);
  if (slopes) out.slope[0] = -out.value[0] / 2 * StateMatrix(StateMatrix(P).inverse());
}

constexpr auto kTrace = of_block<Trace>;
constexpr auto kTracePart = one_part<Trace>;
constexpr auto kTraces = in_lanes<Trace>;

// Convex in P: P_ii and tr P, which are linear; λmax = max_u uᵀPu and ‖P‖, a maximum
// and a norm; |P|^(−1/2), the exponential of the convex −½ log |P|. |P| is neither
// convex nor concave.
constexpr MetricRow kTable[] = {
    // name, kind, reads, power, larger is better, root, convex, value, parts, lanes
    {"sigma_", MetricKind::sigma, MetricReads::one_state, 1, false, true, true,
     variance, variance_part, nullptr},
    {"sigma_horizontal", MetricKind::sigma_horizontal, MetricReads::horizontal, 1,
     false, true, true, horizontal, horizontal_part, horizontals},
    {"sigma_position", MetricKind::sigma_position, MetricReads::position, 1, false,
     true, true, kTrace, kTracePart, kTraces},
    {"sigma_orientation", MetricKind::sigma_orientation, MetricReads::orientation, 1,
     false, true, true, kTrace, kTracePart, kTraces},
    {"eigmax", MetricKind::eigmax, MetricReads::block, 1, false, true, true,
     of_block<Largest>, eigenvalues, largest_in_lanes},
    {"eiglen", MetricKind::eiglen, MetricReads::block, 1, false, true, true,
     of_block<Norm>, one_part<Norm>, in_lanes<Norm>},
    {"mle", MetricKind::mle, MetricReads::whole_state, 0, true, false, true, likelihood,
     likelihood_part, nullptr},
    {"trace", MetricKind::trace, MetricReads::block, 2, false, false, true, kTrace,
     kTracePart, kTraces},
    {"det", MetricKind::det, MetricReads::block, 2, false, false, false,
     of_block<Determinant>, one_part<Determinant>, in_lanes<Determinant>},
    {"coverage", MetricKind::coverage, MetricReads::devices, 0, true, false, false,
     nullptr, nullptr, nullptr},
    {"footprint", MetricKind::footprint, MetricReads::devices, 1, false, false, false,
     nullptr, nullptr, nullptr},
    {"latency", MetricKind::latency, MetricReads::closed_loop, 0, false, false, false,
     nullptr, nullptr, nullptr},
    {"nonlinearity", MetricKind::nonlinearity, MetricReads::readings, 0, false, false,
     false, nullptr, nullptr, nullptr},
    {"unscented_ratio", MetricKind::unscented_ratio, MetricReads::readings, 0, false,
     false, false, nullptr, nullptr, nullptr},
};

// What a formula reads stands in the formula.
constexpr MetricRow kOfFormulas = {"",
                                   MetricKind::expression,
                                   MetricReads::others,
                                   0,
                                   false,
                                   false,
                                   false,
                                   nullptr,
                                   nullptr,
                                   nullptr};

MetricNeed need_of(const MetricInput& input, const StateLayout& layout) {
  switch (input.kind) {
    case MetricInput::Kind::metric:
      return need_of(input.metric, layout);
    case MetricInput::Kind::entry:
      return std::max(input.row, input.column) < layout.coordinates()
                 ? MetricNeed::pose_block
                 : MetricNeed::whole_state;
    case MetricInput::Kind::position:
      break;
  }
  return MetricNeed::nothing;
}

}  // namespace

std::span<const MetricRow> metric_table() { return kTable; }

const MetricRow& row_of(MetricKind kind) {
  if (kind == MetricKind::expression) return kOfFormulas;
  return *std::find_if(std::begin(kTable), std::end(kTable),
                       [kind](const MetricRow& row) { return row.kind == kind; });
}

MetricNeed need_of(const Metric& metric, const StateLayout& layout) {
  if (metric.expression) {
    MetricNeed most = MetricNeed::nothing;
    for (const MetricInput& input : metric.expression->inputs)
      most = std::max(most, need_of(input, layout));
    return most;
  }
  switch (row_of(metric.kind).reads) {
    case MetricReads::devices:
      return MetricNeed::nothing;
    case MetricReads::closed_loop:
      return MetricNeed::time_constant;
    case MetricReads::whole_state:
    case MetricReads::readings:
      return MetricNeed::whole_state;
    case MetricReads::one_state:
      if (metric.state >= layout.coordinates()) return MetricNeed::whole_state;
      break;
    default:
      break;
  }
  return MetricNeed::pose_block;
}

BlockPlace place_of(const Metric& metric, const StateLayout& layout) {
  switch (row_of(metric.kind).reads) {
    case MetricReads::one_state:
      return {metric.state, 1};
    case MetricReads::horizontal:
      return {0, 2};
    case MetricReads::orientation:
      return {layout.positions(), layout.turns()};
    case MetricReads::whole_state:
    case MetricReads::readings:
      return {0, layout.size()};
    default:
      return {0, layout.block()};
  }
}

double variance_value(const Metric& metric, const StateLayout& layout,
                      const StateMatrix& P) {
  const auto [first, size] = place_of(metric, layout);
  return row_of(metric.kind).value(P.block(first, first, size, size));
}

double metric_value(const Metric& metric, const StateLayout& layout,
                    const StateMatrix& P) {
  const double phi = variance_value(metric, layout, P);
  return row_of(metric.kind).root ? std::sqrt(phi) : phi;
}

void metric_values(const Metric& metric, const StateLayout& layout, const double* P,
                   double* values) {
  const MetricRow& row = row_of(metric.kind);
  const auto [s, size] = place_of(metric, layout);
  const auto at = [P, s = s](int i, int j) {
    return P + packed_index(s + i, s + j) * kLanes;
  };
  if (row.lanes) {
    const double* block[6] = {};
    for (int i = 0; i < size; ++i)
      for (int j = 0; j <= i; ++j) block[packed_index(i, j)] = at(i, j);
    row.lanes(block, size, values);
  } else {
    std::copy_n(at(0, 0), kLanes, values);
  }
  if (!row.root) return;
  for (int l = 0; l < kLanes; ++l) values[l] = std::sqrt(values[l]);
}

// φ̃ = (Σ φ_i^p)^(1/p),  ∂φ̃/∂φ_i = (φ_i/φ̃)^(p−1);  ∂√φ̃ = ∂φ̃/(2√φ̃)
double smooth_metric(const Metric& metric, const StateLayout& layout,
                     const StateMatrix& P, double weight, StateMatrix* Y) {
  const MetricRow& row = row_of(metric.kind);
  const auto [first, size] = place_of(metric, layout);
  MetricParts parts;
  row.parts(P.block(first, first, size, size), Y != nullptr, parts);
  double phi = parts.value[0], share[3] = {1, 0, 0};
  if (parts.count > 1) {
    const double largest = *std::max_element(parts.value, parts.value + parts.count);
    double sum = 0;
    for (int i = 0; i < parts.count; ++i) {
      const double ratio = std::max(parts.value[i] / largest, 0.0);
      share[i] = std::pow(ratio, kEigenPower - 1);
      sum += share[i] * ratio;
    }
    phi = largest * std::pow(sum, 1 / kEigenPower);
    for (double& of_part : share) of_part *= phi / (largest * sum);
  }
  const double value = row.root ? std::sqrt(phi) : phi;
  if (!Y) return value;
  if (row.root) weight /= 2 * value;
  for (int i = 0; i < parts.count; ++i)
    Y->block(first, first, size, size) += weight * share[i] * parts.slope[i];
  return value;
}

}  // namespace delos
