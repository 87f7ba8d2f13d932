// The quantities that a field can show.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "delos/api.h"
#include "delos/model/state.h"

namespace delos {

/// Kinds of metric. "Block" is the position block of P∞, or the orientation block of an
/// orientation-only state; a state without either has no metrics of them.
enum class MetricKind {
  sigma,              ///< standard deviation of one state
  sigma_horizontal,   ///< √(σ_x² + σ_y²)
  sigma_position,     ///< √trace of the position block
  sigma_orientation,  ///< √trace of the orientation block
  eigmax,        ///< √(largest eigenvalue of the block): Eq. 48, as plotted in metres
  eiglen,        ///< (Σ λᵢ²)^(1/4) over the block's eigenvalues: Eq. 47
  mle,           ///< (2π)^(−n/2) |P∞|^(−1/2) of the whole state: Eq. 46
  trace,         ///< trace of the block
  det,           ///< determinant of the block
  coverage,      ///< number of devices that see the target
  footprint,     ///< what a pixel covers at the sample, of the device that does best
  latency,       ///< time constant of the slowest closed-loop pole of A − KH
  nonlinearity,  ///< what linearising readings leaves out, in their noise
  unscented_ratio,  ///< deviation by points of the covariance, over that of P∞
  expression,       ///< a formula of the others: a scene's own
};

struct MetricExpression;  // metric_expression.h

/// A metric of a given state layout. Equations are those of Allen (2007), §4.3.
struct Metric {
  MetricKind kind = MetricKind::eigmax;
  int state = 0;     ///< which state, for MetricKind::sigma
  std::string name;  ///< as in scenes: "sigma_x", "eigmax"
  std::string unit;  ///< SI: "m", "rad/s", "m^2", "s", "1"
  bool larger_is_better = false;
  /// Whether it is never better where P∞ is larger. Where it may be, what nobody sees
  /// might look good to a search, and no guess stands in for what isn't known.
  bool monotone = true;
  /// The formula, for MetricKind::expression.
  std::shared_ptr<const MetricExpression> expression;
};

/// Metrics that have names: those of a state layout, and a scene's own.
struct KnownMetrics {
  KnownMetrics(StateLayout of, std::vector<Metric> its_own = {})
      : layout(std::move(of)), own(std::move(its_own)) {}

  StateLayout layout;
  std::vector<Metric> own;
};

/// The metric of this name.
/// @returns it, or a sentence that says what is wrong and what names there are.
[[nodiscard]] DELOS_API std::variant<Metric, std::string> parse_metric(
    std::string_view name, const KnownMetrics& known);

/// Names of all metrics, those of single states first and a scene's own last.
[[nodiscard]] DELOS_API std::vector<std::string> metric_names(
    const KnownMetrics& known);

}  // namespace delos
