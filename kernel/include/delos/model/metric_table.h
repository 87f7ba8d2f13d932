// What each metric is: what it reads, its value and slope, and whether it is convex.
#pragma once

#include <Eigen/Core>
#include <span>

#include "delos/api.h"
#include "delos/model/metric.h"
#include "delos/model/state.h"

namespace delos {

/// What a metric is a function of.
enum class MetricReads {
  devices,      ///< which devices see the target; nothing of P∞
  one_state,    ///< the variance of one state
  horizontal,   ///< the position block of P∞ without z
  position,     ///< the position block
  orientation,  ///< its orientation block
  block,        ///< the first of these two that the state has
  whole_state,  ///< all of P∞
  closed_loop,  ///< the poles of A − KH
  readings,     ///< all of P∞, and how devices' readings bend over it
  others,       ///< what its formula reads
};

/// What a metric reads of P∞, b×b on the diagonal: 1×1 to 3×3, or n×n.
using CovarianceBlock = Eigen::Ref<const Eigen::MatrixXd>;

/// φ(P) = max_i φ_i(P), and what each part changes with P. All metrics but eigmax,
/// whose parts are the eigenvalues, have one part.
struct MetricParts {
  int count = 0;
  double value[3];
  StateMatrix slope[3];  ///< ∂φ_i/∂P, b×b, symmetric
};

/// A row of the table of metrics.
///
/// A metric is φ or √φ, where φ is the variance, or the like, that is convex in P if
/// anything is. φ rises with P, but where the larger metric is the better one.
struct MetricRow {
  const char* name;  ///< as in scenes; of MetricKind::sigma, the part before the state
  MetricKind kind;
  MetricReads reads;
  /// The metric's unit is that of the block to this power, of det once a coordinate; 0:
  /// another one.
  int power;
  bool larger_is_better;
  bool root;    ///< whether the metric is √φ, a deviation
  bool convex;  ///< whether φ is known to be convex in P
  /// φ of one P; null where the metric reads nothing of P.
  double (*value)(const CovarianceBlock& P);
  /// φ_i, and on request their slopes. @pre P is positive definite
  void (*parts)(const CovarianceBlock& P, bool slopes, MetricParts& out);
  /// φ of kLanes blocks side by side, bit for bit as value(); null where it is the
  /// first entry, or of the whole state.
  /// @param P the rows of kLanes numbers of (0,0), (1,0), (1,1), (2,0), …
  /// @param size b, 1 to 3
  void (*lanes)(const double* const P[6], int size, double* values);
};

/// All metrics, in the order in which they are listed.
[[nodiscard]] DELOS_API std::span<const MetricRow> metric_table();
[[nodiscard]] DELOS_API const MetricRow& row_of(MetricKind kind);

/// What must be solved for a metric; of a formula, the most that its parts need.
enum class MetricNeed {
  nothing,        ///< coverage: which devices see the target
  pose_block,     ///< the pose's covariance alone
  whole_state,    ///< P∞
  time_constant,  ///< P∞ and the closed loop's slowest pole
};
[[nodiscard]] DELOS_API MetricNeed need_of(const Metric& metric,
                                           const StateLayout& layout);

/// Where the block that a metric reads stands in P∞.
struct BlockPlace {
  int first = 0, size = 0;
};
/// @pre the metric reads something of P∞
[[nodiscard]] DELOS_API BlockPlace place_of(const Metric& metric,
                                            const StateLayout& layout);

/// φ of P∞: the square of a metric that is a root, else the metric.
/// @param P n×n, or d×d where the metric needs no more
/// @pre the metric reads something of P∞
[[nodiscard]] DELOS_API double variance_value(const Metric& metric,
                                              const StateLayout& layout,
                                              const StateMatrix& P);

/// Value of a metric of P∞. @param P, @pre as variance_value()
[[nodiscard]] DELOS_API double metric_value(const Metric& metric,
                                            const StateLayout& layout,
                                            const StateMatrix& P);

/// A metric of kLanes pose covariances.
/// @param P d×d each, packed as model/lanes.h says
/// @param[out] values kLanes numbers
/// @pre need_of(metric) == MetricNeed::pose_block
DELOS_API void metric_values(const Metric& metric, const StateLayout& layout,
                             const double* P, double* values);

/// The exponent of the eigenvalues' norm that stands for the largest one.
inline constexpr double kEigenPower = 16;

/// A metric that has slopes everywhere: the largest part of φ is replaced by
/// (Σ φ_i^p)^(1/p), p = kEigenPower. The same metric where there is one part.
/// @param[in,out] Y null, or as P: weight ∂value/∂P is added to it
[[nodiscard]] DELOS_API double smooth_metric(const Metric& metric,
                                             const StateLayout& layout,
                                             const StateMatrix& P, double weight,
                                             StateMatrix* Y);

}  // namespace delos
