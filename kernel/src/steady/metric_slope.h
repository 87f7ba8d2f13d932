// Metrics of one pose as functions of the information, and their slopes.
#pragma once

#include <memory>
#include <vector>

#include "delos/model/metric_expression.h"
#include "delos/steady/state_metric.h"
#include "delos/steady/steady_solver.h"

namespace delos {

/// The smooth_metric()s of a system at one pose; see slope_problem(). Reentrant with a
/// Scratch a thread.
class MetricSlope {
 public:
  MetricSlope(const System& system, const std::vector<Metric>& metrics);

  /// Memory of one thread.
  struct Scratch {
    SteadyEquation at;
    FusedState state;
  };
  [[nodiscard]] Scratch make_scratch() const { return {solver_->equation(), {}}; }

  /// @param S information of one update, or its rate, packed as model/lanes.h says
  /// @param[out] values one a metric; +∞ where it isn't finite
  void values(const double* S, const PoseFacts& facts, Scratch& scratch,
              double* values) const;

  /// Σ_m weight_m ∂value_m/∂S
  /// @param[out] G information_size() square, symmetric; zero where the state isn't
  ///             observable
  /// @returns Σ_m weight_m ∂value_m/∂seen
  double slope(const double* S, const PoseFacts& facts, const double* weights,
               Scratch& scratch, StateMatrix& G) const;

 private:
  /// Whether a metric, of those with a weight, is one of P∞.
  [[nodiscard]] bool reads_state(const double* weights) const;
  /// A metric of P∞, or of a null one where it reads nothing of it.
  double value(const Metric& metric, const StateMatrix* P,
               const PoseFacts& facts) const;
  double input_value(const MetricInput& input, const StateMatrix* P,
                     const PoseFacts& facts) const;
  /// weight ∂value/∂P, and ∂value/∂seen, are added to Y and g.
  void add_slope(const Metric& metric, const StateMatrix* P, const PoseFacts& facts,
                 double weight, StateMatrix& Y, double& g) const;
  /// P∞ of a pose; null where it has no finite value.
  const StateMatrix* solve(const double* S, Scratch& scratch) const;

  std::unique_ptr<const SmoothSteadySolver> solver_;
  std::vector<Metric> metrics_;
  StateLayout layout_;
  CovarianceKind kind_;
  SteadyRequest request_;
};

}  // namespace delos
