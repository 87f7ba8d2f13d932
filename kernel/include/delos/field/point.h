// Everything about one point: covariances, metrics, what is lost and which device
// matters.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/model/metric.h"
#include "delos/rig/system.h"
#include "delos/steady/fused_state.h"
#include "delos/steady/solver.h"

namespace delos {

/// What one device is to a point.
struct DeviceShare {
  std::string name;
  std::string type;
  bool visible = false;
  /// Relative rise of the metric's loss when this device alone is taken away; +∞ where
  /// the metric is lost without it, NaN where it is lost with it too. 0.5: half as
  /// large again.
  double share = 0;
  /// Relative fall of the metric's loss if this device alone were known exactly; 0: its
  /// calibration isn't in doubt.
  double calibration = 0;
};

/// What one error that devices have in common is to a point.
struct CommonErrorShare {
  std::string name;
  double calibration = 0;  ///< relative fall of the metric's loss without it
};

/// A metric and its value; +∞ where it reads a direction that isn't observed.
struct MetricValue {
  Metric metric;
  double value = 0;
};

/// What the metrics are of each part of the error, in the order of
/// PointReport::metrics, where some device says how well it is known.
struct ErrorBudget {
  std::vector<double> scatter, bias, total;
  std::vector<CommonErrorShare> common;  ///< where numbers count the bias
  /// The metric of what plain least squares of one reading makes: all readings weighed
  /// alike, no motion. nullopt where devices of several types have no common scale, and
  /// of metrics that need more than a pose.
  struct Plain {
    double scatter, bias, total;
  };
  std::optional<Plain> plain;
};

/// Everything about one pose.
struct PointReport {
  TargetPose pose;
  bool inside = false;  ///< within a solid, where no field has a value
  FusedState state;
  Solver solver = Solver::automatic;  ///< which one answered
  bool careful = false;  ///< from the stacked whitened rows, not from their product
  std::vector<MetricValue> metrics;  ///< every metric of the layout
  std::vector<DeviceShare> devices;
  std::optional<ErrorBudget> budget;
  /// Of the prior, where it solves one update's equation: how well. Else NaN.
  double residual = 0;
};

/// Evaluate one pose. Where the spectral reduction holds, it is taken from the whitened
/// rows themselves (spectral_form_of_rows), which keeps twice the digits of the
/// smallest eigenvalue that a field has.
/// @param metric what the shares are about
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] DELOS_API PointReport evaluate_point(const System& system,
                                                   const TargetPose& pose,
                                                   const Metric& metric,
                                                   Solver solver = Solver::automatic);

}  // namespace delos
